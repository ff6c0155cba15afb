#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "sim/core/aligned.h"
#include "sim/front/detector.h"
#include "sim/front/fit_lanes.h"
#include "sim/front/point_estimator.h"

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
//            \  / \  / \         (each edge drawn is uncut)
//     ········\/···\/···\····
struct OneSidedNeighbourhood {
    static constexpr int kRings = 4;

    std::span<const int> vertices;         // a first, then ring after ring
    std::array<int, kRings + 1> ring_end;  // where each ring ends there; the first is a alone

    // Their flips, the newest first: of which vertex, and what is known of it; lists are filled up to whole
    // lanes with zeros. Which way the front went is turned round at each flip before another of the same
    // vertex, which was on the other side in between.
    std::span<const int> flipped;
    fit::Flipped flips;

    // Edges from there that a front crosses.
    struct Crossing {
        int here, beyond;  // vertices
    };
    std::span<const Crossing> crossings;
};

// The shores of one moment. Each is looked at once, however many edges are cut at its vertex.
class OneSidedNeighbourhoods {
  public:
    OneSidedNeighbourhoods(std::size_t vertices, const fit::Kernels& kernels)
        : kernels_(kernels), found_(vertices), seen_(vertices, 0) {}

    // Forgets all: another moment begins.
    void clear();

    // Its number. `cuts`: of each vertex of the mesh, how many of its edges are cut. `time`: now, s.
    int find(const Detector& detector, std::span<const int> cuts, std::span<const Flips> flips, double time,
             int vertex);
    // Until the next is sought.
    OneSidedNeighbourhood operator[](int number) const;

  private:
    struct Extent {
        std::size_t vertex, flip, number, crossing;  // where it begins
        std::array<int, OneSidedNeighbourhood::kRings + 1> ring_end;
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

    void make_room(std::size_t more);
    void gather(const Detector& detector, std::span<const int> cuts, Extent& extent);
    void add_beside_front(const Detector& detector, int from, bool goes_on);
    void add_all(const Mesh& mesh, int from);
    void add_flips(const Mesh& mesh, std::span<const Flips> flips, double time, Extent& extent);
    void find_order(double time, int count);

    const fit::Kernels& kernels_;
    std::vector<Extent> extents_;
    std::size_t count_ = 0, crossing_count_ = 0;  // how many of the next two are filled
    std::vector<int> vertices_;
    std::vector<OneSidedNeighbourhood::Crossing> crossings_;
    std::vector<int> flipped_;
    std::vector<double> numbers_;  // of flips
    std::vector<Known> those_;     // flips of the shore that is looked at
    std::vector<int> keys_, order_;

    std::vector<Found> found_;  // of each vertex of the mesh
    std::uint32_t moment_ = 1;
    std::vector<std::uint32_t> seen_;  // of each vertex of the mesh: in which round
    std::uint32_t round_ = 0;
};

}  // namespace sim::front
