#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "sim/front/fit_lanes.h"
#include "sim/front/moving_quadratic.h"
#include "sim/front/one_sided_neighbourhood.h"
#include "sim/front/point_estimator.h"

namespace sim::front {

// The state of a front where it crosses an edge.
struct FrontFit {
    float f = 0.5f;          // as fitted
    glm::vec2 normal{1, 0};  // unit, from the side of vertex a to that of b
    float speed = 0;         // along the normal, m/s
    float bend = 0;          // curvature: change of its slope per metre along it, 1/m
    float entered = -1;      // f at which a new front enters, continuing from where it was shown; -1: unknown
    bool is_new = false;
};

// Fits a piece of moving front (moving_quadratic.h) to the flips around an edge, and intersects it with the
// edge: that is where the front crosses now. Lengths are in cells, the shortest edge at either end; times are
// in windows. Sides are relative to one edge, so any number of regions may meet.
class SpaceTimeFit {
  public:
    SpaceTimeFit(std::size_t vertices, const fit::Kernels& kernels)
        : kernels_(kernels), shores_(vertices, kernels), beyond_(vertices, 0) {}

    // Call before the first edge of each moment.
    void begin_moment() { shores_.clear(); }

    // `piece`: the previous state of the front there. `flips`, `cuts`: for each vertex of the mesh, its flips
    // and its number of cut edges.
    FrontFit operator()(const TrackedMoment& now, std::span<const Flips> flips, std::span<const int> cuts,
                        int edge, FrontFit piece);

  private:
    void claim(const OneSidedNeighbourhood& here, const OneSidedNeighbourhood& beyond);
    bool is_beyond(int vertex) const { return beyond_[vertex] / kRingsOf == round_; }
    void collect_flips(const OneSidedNeighbourhood& here, const OneSidedNeighbourhood& beyond);
    void forget_flips(const OneSidedNeighbourhood& shore, bool of_here, const fit::FlipRows& rows);
    void collect_crossings(const Mesh& mesh, const OneSidedNeighbourhood& here);
    void choose_window(double dt);
    void solve();
    bool misses_newest();
    void keep_sides();
    double find_wrong();
    FrontFit met(const Mesh& mesh, int edge, FrontFit piece) const;

    static constexpr std::uint64_t kRingsOf = 8;  // more than a neighbourhood has

    const fit::Kernels& kernels_;
    OneSidedNeighbourhoods shores_;
    std::vector<std::uint64_t>
        beyond_;  // per vertex: round in which it was last on b's side, times 8, plus its ring
    std::uint64_t round_ = 0;
    bool meet_ = false;  // whether the neighbourhoods share a vertex

    MovingQuadratic front_;
    fit::LocalFrame frame_{};
    // Flips on a's side and on b's, newest first.
    struct Side {
        int count = 0;
        fit::FlipRows rows{};
    };
    std::array<Side, 2> sides_;
    std::vector<double> flip_numbers_, crossing_numbers_;
    int crossings_ = 0;
    double *wrong_ = nullptr, *wrong_beyond_ = nullptr;
    fit::CrossingRows crossing_rows_{};      // wrong_, wrong_beyond_: how far either end is on the wrong side
    MovingQuadratic::Sums<double> crossed_;  // from edges that the front crosses now
    double one_way_ = 0;                     // cosine below which a flip does not count
    double cell_ = 1;                        // m
    double step_ = 0;                        // distance that the front moves per step, cells
    double youngest_ = 0;  // age of the newest flip that counts, s; infinite if there is none
    double window_ = 1, short_window_ = 1;  // s
};

}  // namespace sim::front
