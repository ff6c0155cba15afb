#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "sim/aligned.h"
#include "sim/front/detector.h"
#include "sim/front/locator.h"

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

// What lies around a vertex beside a front, on its own side of all fronts.
//
//           A ── A ── A        A: reached from the vertex a without crossing a front, within kRings.
//            \  / \  / \
//     ········\/···\/···\····
struct Shore {
    static constexpr int kRings = 4;
    static constexpr std::size_t kLanes = 2;  // on any machine, so that sums over them have the same bits
    static constexpr std::size_t filled_up(std::size_t flips) {
        return (flips + kLanes - 1) / kLanes * kLanes;
    }

    std::span<const int> vertices;         // a first, then ring after ring
    std::array<int, kRings + 1> ring_end;  // where each ring ends there; the first is a alone

    // Their flips, the newest first: arrays as long as `flipped`, filled up to whole lanes by such as went
    // nowhere.
    std::span<const int> flipped;  // which of them
    const double *x, *y;           // where it lies, m
    const double* age;             // s
    // Which way the front went, if that was away from this side: unit; of each flip before another of the
    // same vertex the opposite, for in between it was on the other side.
    const double *east, *north;

    struct Crossing {
        int here, beyond;  // ends of a cut edge
    };
    std::span<const Crossing> crossings;  // from those vertices on
};

// The shores of one moment. Each is looked at once, however many edges are cut at its vertex.
class Shores {
  public:
    explicit Shores(std::size_t vertices) : found_(vertices), seen_(vertices, 0) {}

    // Forgets all: another moment begins.
    void clear();

    // Its number. `cuts`: of each vertex of the mesh, how many of its edges are cut. `time`: now, s.
    int find(const Detector& detector, std::span<const int> cuts, std::span<const Flips> flips, double time,
             int vertex);
    // Until the next is sought.
    Shore operator[](int number) const;

  private:
    struct Extent {
        std::size_t vertex, flip, number, crossing;  // where it begins
        std::array<int, Shore::kRings + 1> ring_end;
        int flips, crossings;
    };
    struct Found {
        std::uint32_t moment = 0;
        int number = 0;
    };
    struct Known {
        int vertex;
        float way;  // 1: the newest of its vertex, or one of every other before; -1: one between
        const Flip* flip;
    };

    void gather(const Detector& detector, std::span<const int> cuts, Extent& extent);
    void make_room(std::size_t more);
    void add_beside_front(const Detector& detector, int from, bool goes_on);
    void add_all(const Mesh& mesh, int from);
    void add_flips(const Mesh& mesh, std::span<const Flips> flips, double time, Extent& extent);
    void find_order(double time, std::size_t count);

    static constexpr int kNumbers = 5;  // of a flip

    std::vector<Extent> extents_;
    std::vector<int> vertices_;
    std::size_t count_ = 0, crossing_count_ = 0;  // how many of the next two are filled
    std::vector<Shore::Crossing> crossings_;
    std::vector<int> flipped_;
    std::vector<double> numbers_;
    std::vector<Known> those_;  // flips of the shore that is looked at
    std::vector<int> keys_, order_;

    std::vector<Found> found_;  // of each vertex of the mesh
    std::uint32_t moment_ = 1;
    std::vector<std::uint32_t> seen_;  // of each vertex of the mesh: in which round
    std::uint32_t round_ = 0;
};

}  // namespace sim::front
