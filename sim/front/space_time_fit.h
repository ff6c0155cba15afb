#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "sim/aligned.h"
#include "sim/front/locator.h"
#include "sim/front/moving_quadratic.h"
#include "sim/front/neighbourhood.h"

namespace sim::front {

// When a front passed a vertex, and which way.
struct Flip {
    double time = kNever;       // s
    glm::vec2 direction{0, 0};  // in which the front went, unit
};

// The last that a vertex remembers, the newest first, in a cache line: they are asked for all over the place.
struct alignas(kCacheLine) Flips {
    std::array<Flip, 3> last;
    std::array<bool, 3> expected{true, true, true};  // the front was known to be near
};

// What is known of a front where it crosses an edge.
struct Piece {
    float f = 0.5f;          // as fitted
    glm::vec2 normal{1, 0};  // unit, from the side of vertex a to that of b
    float speed = 0;         // along the normal, m/s
    float bend = 0;          // of the front there: what its slope gains per metre along it, 1/m
    bool is_new = false;
};

// Lays a piece of moving front (moving_quadratic.h) through the flips around an edge, and meets the edge with
// it: where it crosses the edge now. Lengths are in cells: the shorter of the shortest edges at both ends;
// times in windows. Sides are those of one edge, so any number of regions may meet.
class SpaceTimeFit {
  public:
    explicit SpaceTimeFit(std::size_t vertices) : near_(vertices) {}

    // `piece` is what was known of the front there until now. Of each vertex of the mesh: its flips, and how
    // many of its edges are cut.
    Piece operator()(const Moment& now, std::span<const Flips> flips, std::span<const int> cuts, int edge,
                     Piece piece);

  private:
    struct Row {
        double s, D, age, weight;
    };
    struct Middle {  // of an edge that the front crosses now, which goes so far across
        double s, D, across, weight;
    };
    struct End {
        double s, D, side;
    };

    std::pair<double, double> place(const glm::vec2& position) const;  // s and D
    void collect_flips(const Moment& now, std::span<const Flips> flips);
    void collect_crossings(const Mesh& mesh);
    void choose_window(double dt);
    void solve();
    double violation(const End& end) const;
    bool misses_newest() const;
    void keep_sides();
    Piece met(const Mesh& mesh, int edge, Piece piece) const;

    Neighbourhood near_;
    MovingQuadratic front_;
    std::vector<Row> rows_;
    std::vector<Middle> middles_;
    std::vector<End> ends_;
    glm::dvec2 middle_{0, 0}, normal_{1, 0};  // of the edge, m; across it, unit
    double one_way_ = 0;                      // cosine, below which a flip does not count
    double cell_ = 1;                         // m
    double step_ = 0;                         // what the front goes in a step, cells
    double window_ = 1, short_window_ = 1;    // s
};

}  // namespace sim::front
