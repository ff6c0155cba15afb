#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "sim/core/grid.h"
#include "terrains/limits.h"

namespace terrains {

// The grid spacing that a caller wants, and its check of the resulting grid.
struct GridChoice {
    // May refuse a grid, with a reason. Called before memory is allocated for it.
    using Allowed = std::function<tl::expected<void, std::string>(const sim::Grid&)>;
    GridChoice(int along_longer, Allowed may_have = nullptr)
        : squares(along_longer), allowed(std::move(may_have)) {}

    int squares;  // along the longer side, 8 to 4096; kOwn: of a raster with square pixels, one per pixel
    static constexpr int kOwn = 0;
    Allowed allowed;
};

// Square cells over a rectangle of width × height metres: `squares` along the longer side, as many whole ones
// as fit along the shorter. dx is rounded down to float32, so that no vertex lies outside the rectangle.
// Errors: squares outside 8 to 4096, a rectangle so narrow that fewer than 2 squares fit across, or a grid
// that is not allowed.
tl::expected<sim::Grid, std::string> grid_over(double width, double height, const GridChoice& choice);

// Resamples heights of scattered points to a grid, by a plane fitted around every vertex with tent weights.
// For a regular raster finer than the grid this is the tent filter (antialiased), for a coarser one it is
// bilinear interpolation. Unlike either it reproduces every plane exactly, also at borders, around voids and
// on warped rasters. Points are added in any order; sums are in double, so the order affects only the last
// bits.
class PlaneFit {
  public:
    // reach_x, reach_y: half the tent's base, m; at least dx and at least the distance between points on that
    // axis. point_area: m² of ground per point, to tell a vertex in the raster from one beyond its edge.
    PlaneFit(const sim::Grid& grid, double reach_x, double reach_y, double point_area);

    // Adds a point, m from vertex (0, 0), and its height, m; or `count` points with their mean position and
    // height.
    void add(double x, double y, double height, double count = 1);
    void add_void(double x, double y, double count = 1);  // points of unknown height

    // 1 if the vertex lies among the points, at least half of its weight is known, and a plane is determined.
    // Elsewhere surface is 0 until fill_voids() extends it.
    struct Fitted {
        std::vector<float> surface;
        std::vector<std::uint8_t> has_data;
    };
    Fitted finish() const;

  private:
    // Moments about the vertex, in units of the reach.
    struct Sums {
        double all = 0;                                      // weight of known and unknown points
        double w = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;  // of the known ones
        double z = 0, xz = 0, yz = 0;                        // and of their heights
    };
    template <class Visit>
    void for_vertices_near(double x, double y, Visit visit);
    static bool solve(const Sums& s, double& height);

    sim::Grid grid_;
    double reach_x_, reach_y_, full_weight_;
    std::vector<Sums> sums_;
};

// Gives every vertex without data a height. Next to known ground it extrapolates the neighbours' slope
// (averaged over the directions in which two known vertices follow each other), farther out it is the mean of
// filled neighbours. Leaves has_data unchanged. At least one vertex must be known.
void fill_voids(const sim::Grid& grid, const std::vector<std::uint8_t>& has_data,
                std::vector<float>& surface);

}  // namespace terrains
