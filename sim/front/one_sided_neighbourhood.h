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

// When a front passed a vertex, and in which direction.
struct Flip {
    double time = kNever;       // s
    glm::vec2 direction{0, 0};  // in which the front went, unit
};

// The last flips of a vertex, newest first. They fill one cache line, because they are read in random order.
struct alignas(kCacheLine) Flips {
    std::array<Flip, 3> last;
    std::array<bool, 3> expected{true, true, true};  // the front was known to be near
};

// The vertices around a vertex beside a front, on its own side of all fronts.
//
//           A ── A ── A        A: reached from the vertex a without crossing a front, within kRings.
//            \  / \  / \         (each edge drawn is uncut)
//     ········\/···\/···\····
struct OneSidedNeighbourhood {
    static constexpr int kRings = 4;

    std::span<const int> vertices;         // a first, then ring by ring
    std::array<int, kRings + 1> ring_end;  // where each ring ends in `vertices`; the first ring is a alone

    // Flips of those vertices, newest first: the vertex, and the data of the flip, filled up to whole lanes
    // with zeros. The direction is reversed at every second flip of the same vertex, because the vertex was
    // on the other side in between.
    std::span<const int> flipped;
    fit::Flipped flips;

    // Cut edges from those vertices.
    struct Crossing {
        int here, beyond;  // vertices
    };
    std::span<const Crossing> crossings;
};

// The neighbourhoods of one moment. Each is computed once, however many edges are cut at its vertex.
class OneSidedNeighbourhoods {
  public:
    OneSidedNeighbourhoods(std::size_t vertices, const fit::Kernels& kernels)
        : kernels_(kernels), found_(vertices), seen_(vertices, 0) {}

    // Clears all neighbourhoods before another moment.
    void clear();

    // Finds a vertex's neighbourhood and returns its number. `cuts`: cut edges at each vertex of the mesh.
    // `time`: now, s.
    int find(const Detector& detector, std::span<const int> cuts, std::span<const Flips> flips, double time,
             int vertex);
    // Valid until the next call of find().
    OneSidedNeighbourhood operator[](int number) const;

  private:
    struct Extent {
        std::size_t vertex, flip, number, crossing;  // where each list begins
        std::array<int, OneSidedNeighbourhood::kRings + 1> ring_end;
        int flips, crossings;
    };
    struct Found {
        std::uint32_t moment = 0;
        int number = 0;
    };
    struct Known {
        int vertex;
        float way;  // 1: the newest flip of its vertex, and every second before it; -1: the others
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
    std::size_t count_ = 0, crossing_count_ = 0;  // filled part of the next two
    std::vector<int> vertices_;
    std::vector<OneSidedNeighbourhood::Crossing> crossings_;
    std::vector<int> flipped_;
    std::vector<double> numbers_;  // of flips
    std::vector<Known> those_;     // flips of the neighbourhood being computed
    std::vector<int> keys_, order_;

    std::vector<Found> found_;  // per vertex of the mesh
    std::uint32_t moment_ = 1;
    std::vector<std::uint32_t> seen_;  // per vertex of the mesh: last round in which it was seen
    std::uint32_t round_ = 0;
};

}  // namespace sim::front
