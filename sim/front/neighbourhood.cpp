#include "sim/front/neighbourhood.h"

namespace sim::front {

void Neighbourhood::gather(const Detector& detector, std::span<const int> cuts, int edge) {
    const Mesh& mesh = detector.mesh();
    count_ = 0, crossings_.clear();
    round_ += 2;
    add(mesh.edge[edge].a, 1), add(mesh.edge[edge].b, -1);
    std::size_t first = 0;
    for (int ring = 0; ring <= kRings; ++ring)
        for (const std::size_t last = count_; first < last; ++first) {
            const Vertex from = vertices_[first];
            if (cuts[from.vertex] > 0 && from.side > 0) add_crossings(detector, from.vertex);
            if (ring == kRings) continue;
            if (cuts[from.vertex] > 0)
                add_uncut(detector, from);
            else
                add_all(mesh, from);
        }
    std::erase_if(crossings_, [&](const Crossing& c) { return seen_[c.b] != round_; });
}

void Neighbourhood::add(int vertex, int side) {
    make_room(1);
    vertices_[count_++] = {vertex, side};
    seen_[vertex] = mark(side);
}

void Neighbourhood::make_room(std::size_t more) {
    if (count_ + more > vertices_.size()) vertices_.resize(2 * (count_ + more));
}

void Neighbourhood::add_crossings(const Detector& detector, int from) {
    for (const auto& spoke : detector.mesh().around(from))
        if (detector.is_cut(spoke.edge)) crossings_.push_back({from, spoke.vertex});
}

void Neighbourhood::add_uncut(const Detector& detector, const Vertex& from) {
    for (const auto& spoke : detector.mesh().around(from.vertex))
        if (!detector.is_cut(spoke.edge) && !is_seen(spoke.vertex)) add(spoke.vertex, from.side);
}

// Where no edge is cut, which is nearly everywhere. Each is written, and kept if it is new: a branch, which
// nobody could foretell, would cost more.
void Neighbourhood::add_all(const Mesh& mesh, const Vertex& from) {
    const auto around = mesh.around(from.vertex);
    make_room(around.size());
    Vertex* next = vertices_.data() + count_;
    std::uint32_t* const all_seen = seen_.data();
    const std::uint32_t now = mark(from.side);
    const int side = from.side;
    for (const auto& spoke : around) {
        std::uint32_t& seen = all_seen[spoke.vertex];
        const bool is_new = (seen | 1) != (now | 1);
        *next = {spoke.vertex, side};
        seen = is_new ? now : seen;
        next += is_new;
    }
    count_ = static_cast<std::size_t>(next - vertices_.data());
}

}  // namespace sim::front
