#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/front/detector.h"

namespace sim::front {

// The vertices around a cut edge, told apart by the side of the front on which they lie.
//
//           A ── A ── A        A, B: reached from either end of the edge without crossing the front,
//            \  / \  / \       within kRings. One that both reach is the nearer one's.
//     ········\/···\/···\····
//              B ── B ── B
class Neighbourhood {
  public:
    static constexpr int kRings = 4;

    explicit Neighbourhood(std::size_t count) : seen_(count, 0) {}

    struct Vertex {
        int vertex;
        int side;  // 1: A's, -1: B's
    };
    struct Crossing {
        int a, b;  // ends of a cut edge on A's and on B's side
    };

    // `cuts`: of each vertex of the mesh, how many of its edges are cut.
    void gather(const Detector& detector, std::span<const int> cuts, int edge);

    // Of the last edge: its ends first, then ring after ring.
    std::span<const Vertex> vertices() const { return {vertices_.data(), count_}; }
    std::span<const Crossing> crossings() const { return crossings_; }

  private:
    void add(int vertex, int side);
    void make_room(std::size_t more);
    void add_crossings(const Detector& detector, int from);
    void add_uncut(const Detector& detector, const Vertex& from);
    void add_all(const Mesh& mesh, const Vertex& from);
    std::uint32_t mark(int side) const { return round_ + (side > 0); }
    bool is_seen(int vertex) const { return (seen_[vertex] | 1) == (round_ | 1); }

    std::vector<Vertex> vertices_;
    std::size_t count_ = 0;
    std::vector<Crossing> crossings_;
    std::vector<std::uint32_t> seen_;  // of each vertex: in which round, times 2, and 1 if on A's side
    std::uint32_t round_ = 0;
};

}  // namespace sim::front
