#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "sim/core/grid.h"

namespace render {

// The mountains around a world's grid. They are for the eye alone: nothing lies there, nothing flows there.
// They are made from the grid's own ground, so that they look like it:
//
//   grid            its first surface; holes (no-data) are filled from their rim, with crags of noise
//   beside it       the same, mirrored at the border and bent by noise; slopes carry on over the border, and
//                   nothing near rises high above it, so that no second wall stands in front of the grid
//                   if much of the grid is holes, crags of noise as in them
//   from half a side   noise makes ridges
//   from one side      far ranges, wider and higher
//
// Heights are metres above datum, places metres from vertex (0, 0) as in shaders. Equal ground gives equal
// surroundings on one machine.
class Surroundings {
  public:
    static constexpr double kReach = 9;       // longer sides from a border to the end of the surroundings
    static constexpr double kRoughReach = 2;  // and to the end of the rough heights
    static constexpr int kRough = 320;        // vertices along a side of the rough heights

    // None: no ground.
    Surroundings() = default;
    // The ground of a world at tick 0, one value per vertex, row 0 the south: bedrock, m above datum; depth of the
    // standing layer, m; 0 where there is no data. With two materials also the part of `depth` that is the lower one.
    Surroundings(const sim::Grid& grid, std::span<const float> bedrock, std::span<const float> depth,
                 std::span<const std::uint8_t> has_data, std::span<const float> lower_depth = {});

    bool empty() const { return surface_.empty(); }
    // Equal for equal surroundings, else different but for one chance in 2⁶⁴.
    std::uint64_t fingerprint() const { return fingerprint_; }

    double height(glm::dvec2 at) const;
    // The same within a fraction of a cell on the grid, and by interpolation between vertices of the rough
    // heights outside; as far away as these reach, beyond them the height of their nearest border. Fast.
    double rough_height(glm::dvec2 at) const;
    // The vertices of the rough heights, row 0 the south. They span a square around the grid's middle.
    std::span<const float> rough_heights() const { return rough_; }
    glm::dvec2 rough_origin() const { return rough_origin_; }  // of vertex (0, 0), m
    double rough_cell() const { return rough_cell_; }          // m

    // The place on the grid whose material and first depth are drawn at a place.
    glm::dvec2 source(glm::dvec2 at) const;
    // The standing layer on the grid at tick 0, one value per vertex, holes filled: its depth, m, and the share of the
    // lower material at its surface.
    std::span<const glm::vec2> cover() const { return cover_; }
    // What is added to the cover of a place's source, because the place is higher or lower than that: the difference
    // between the mean covers at these two heights.
    glm::dvec2 cover_by_height(glm::dvec2 at) const;
    // Distance from the grid, m; 0 on it.
    double away(glm::dvec2 at) const;
    bool is_hole(int x, int y) const { return hole_[index(x, y)] != 0; }

    double side() const { return side_; }      // the longer one, m
    glm::dvec2 size() const { return size_; }  // m
    int columns() const { return nx_; }        // vertices of the grid along x
    int rows() const { return ny_; }
    double highest() const { return highest_ + relief_; }  // no surroundings are higher, m
    double cell() const { return cell_; }                  // of the grid, m

    // The distance at which a ray first meets ground outside the grid; `along` is a unit vector.
    std::optional<double> meet(glm::dvec3 from, glm::dvec3 along) const;

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(x);
    }
    void fill_holes();
    void make_crags();
    double crags_at(glm::dvec2 at, double spacing) const;
    void mark(std::span<const std::byte> bytes);
    void make_rough();
    void find_mean_covers();
    glm::dvec2 mean_cover(double z) const;
    double on_grid(const std::vector<float>& field, glm::dvec2 at) const;
    double mirrored(glm::dvec2 at, double spacing) const;
    double carried_on(glm::dvec2 at, double away) const;

    int nx_ = 0, ny_ = 0;
    double missing_ = 0;  // twice the share of the grid that is holes, at most 1
    double cell_ = 0, side_ = 0, lowest_ = 0, highest_ = 0, relief_ = 0;
    glm::dvec2 size_{0};
    std::vector<float> surface_;  // of the grid at tick 0, m
    std::vector<float> smooth_;   // the same without crags in holes, m
    std::vector<glm::vec2> cover_;
    std::vector<glm::dvec2> mean_covers_;  // at equal steps of height from lowest to highest ground
    std::vector<std::uint8_t> hole_;
    std::vector<float> from_rim_;  // of a hole, m; 0 where there is data
    std::vector<float> rough_;
    glm::dvec2 rough_origin_{0};
    double rough_cell_ = 0;
    std::uint64_t fingerprint_ = 0xcbf29ce484222325u;
};

}  // namespace render
