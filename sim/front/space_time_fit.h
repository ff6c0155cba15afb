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

// What is known of a front where it crosses an edge.
struct FrontFit {
    float f = 0.5f;          // as fitted
    glm::vec2 normal{1, 0};  // unit, from the side of vertex a to that of b
    float speed = 0;         // along the normal, m/s
    float bend = 0;          // of the front there: what its slope gains per metre along it, 1/m
    float entered = -1;      // f where a new one came in, going on as it was shown before; -1: nobody knows
    bool is_new = false;
};

// Lays a piece of moving front (moving_quadratic.h) through the flips around an edge, and meets the edge with
// it: where it crosses the edge now. Lengths are in cells: the shorter of the shortest edges at both ends;
// times in windows. Sides are those of one edge, so any number of regions may meet.
class SpaceTimeFit {
  public:
    SpaceTimeFit(std::size_t vertices, const fit::Kernels& kernels)
        : kernels_(kernels), shores_(vertices, kernels), beyond_(vertices, 0) {}

    // Before the first edge of each moment.
    void begin_moment() { shores_.clear(); }

    // `piece` is what was known of the front there until now. Of each vertex of the mesh: its flips, and how
    // many of its edges are cut.
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

    static constexpr std::uint64_t kRingsOf = 8;  // more than a shore has

    const fit::Kernels& kernels_;
    OneSidedNeighbourhoods shores_;
    std::vector<std::uint64_t>
        beyond_;  // of each vertex: when it last lay on b's side, times 8, and its ring
    std::uint64_t round_ = 0;
    bool meet_ = false;  // whether a vertex is on both shores

    MovingQuadratic front_;
    fit::LocalFrame frame_{};
    // Flips on a's side and on b's, the newest first.
    struct Side {
        int count = 0;
        fit::FlipRows rows{};
    };
    std::array<Side, 2> sides_;
    std::vector<double> flip_numbers_, crossing_numbers_;
    int crossings_ = 0;
    double *wrong_ = nullptr, *wrong_beyond_ = nullptr;
    fit::CrossingRows crossing_rows_{};      // how far either end is on the wrong side: wrong_, wrong_beyond_
    MovingQuadratic::Sums<double> crossed_;  // of edges that the front crosses now
    double one_way_ = 0;                     // cosine, below which a flip does not count
    double cell_ = 1;                        // m
    double step_ = 0;                        // what the front goes in a step, cells
    double youngest_ = 0;                    // age of the newest flip that counts, s; without one infinite
    double window_ = 1, short_window_ = 1;   // s
};

}  // namespace sim::front
