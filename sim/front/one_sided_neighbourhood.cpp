#include "sim/front/one_sided_neighbourhood.h"

#include <bit>

namespace sim::front {

void OneSidedNeighbourhoods::clear() {
    extents_.clear(), flipped_.clear(), numbers_.clear();
    count_ = crossing_count_ = 0;
    ++moment_;
}

int OneSidedNeighbourhoods::find(const Detector& detector, std::span<const int> cuts,
                                 std::span<const Flips> flips, double time, int vertex) {
    Found& found = found_[vertex];
    if (found.moment == moment_) return found.number;
    found = {moment_, static_cast<int>(extents_.size())};
    Extent extent{count_, flipped_.size(), numbers_.size(), crossing_count_, {}, 0, 0};
    make_room(1);
    vertices_[count_++] = vertex;
    seen_[vertex] = ++round_;
    gather(detector, cuts, extent);
    add_flips(detector.mesh(), flips, time, extent);
    extents_.push_back(extent);
    return found.number;
}

OneSidedNeighbourhood OneSidedNeighbourhoods::operator[](int number) const {
    const Extent& extent = extents_[number];
    const auto numbers = [&](int which) {
        return numbers_.data() + extent.number + which * fit::filled_up(extent.flips);
    };
    return {.vertices = {vertices_.data() + extent.vertex, static_cast<std::size_t>(extent.ring_end.back())},
            .ring_end = extent.ring_end,
            .flipped = {flipped_.data() + extent.flip, static_cast<std::size_t>(extent.flips)},
            .flips = {numbers(0), numbers(1), numbers(2), numbers(3), numbers(4)},
            .crossings = {crossings_.data() + extent.crossing, static_cast<std::size_t>(extent.crossings)}};
}

void OneSidedNeighbourhoods::make_room(std::size_t more) {
    if (count_ + more > vertices_.size()) vertices_.resize(2 * (count_ + more));
    if (crossing_count_ + more > crossings_.size()) crossings_.resize(2 * (crossing_count_ + more));
}

void OneSidedNeighbourhoods::gather(const Detector& detector, std::span<const int> cuts, Extent& extent) {
    std::size_t next = extent.vertex;
    for (int ring = 0; ring <= OneSidedNeighbourhood::kRings; ++ring) {
        const std::size_t last = count_;
        extent.ring_end[ring] = static_cast<int>(last - extent.vertex);
        for (; next < last; ++next) {
            const int from = vertices_[next];
            if (cuts[from] > 0)
                add_beside_front(detector, from, ring < OneSidedNeighbourhood::kRings);
            else if (ring < OneSidedNeighbourhood::kRings)
                add_all(detector.mesh(), from);
        }
    }
    extent.crossings = static_cast<int>(crossing_count_ - extent.crossing);
}

// Writes each neighbour to both lists and advances only the right one, because unpredictable branches would
// cost more.
void OneSidedNeighbourhoods::add_beside_front(const Detector& detector, int from, bool goes_on) {
    const auto around = detector.mesh().around(from);
    make_room(around.size());
    int* next = vertices_.data() + count_;
    OneSidedNeighbourhood::Crossing* crossing = crossings_.data() + crossing_count_;
    std::uint32_t* const all_seen = seen_.data();
    const std::uint32_t now = round_;
    for (const auto& spoke : around) {
        const bool is_cut = detector.is_cut(spoke.edge);
        std::uint32_t& seen = all_seen[spoke.vertex];
        const bool is_new = goes_on && !is_cut && seen != now;
        *crossing = {from, spoke.vertex}, *next = spoke.vertex;
        seen = is_new ? now : seen;
        crossing += is_cut, next += is_new;
    }
    count_ = static_cast<std::size_t>(next - vertices_.data());
    crossing_count_ = static_cast<std::size_t>(crossing - crossings_.data());
}

// Adds all neighbours of a vertex without a cut edge, the usual case.
void OneSidedNeighbourhoods::add_all(const Mesh& mesh, int from) {
    const auto around = mesh.around(from);
    make_room(around.size());
    int* next = vertices_.data() + count_;
    std::uint32_t* const all_seen = seen_.data();
    const std::uint32_t now = round_;
    for (const auto& spoke : around) {
        std::uint32_t& seen = all_seen[spoke.vertex];
        const bool is_new = seen != now;
        *next = spoke.vertex;
        seen = now;
        next += is_new;
    }
    count_ = static_cast<std::size_t>(next - vertices_.data());
}

void OneSidedNeighbourhoods::add_flips(const Mesh& mesh, std::span<const Flips> flips, double time,
                                       Extent& extent) {
    those_.resize(std::tuple_size_v<decltype(Flips::last)> * (count_ - extent.vertex));
    Known* next = those_.data();
    for (std::size_t i = extent.vertex; i < count_; ++i) {
        const int vertex = vertices_[i];
        const auto& last = flips[vertex].last;
        for (std::size_t which = 0; which < last.size(); ++which) {  // kept if it ever happened
            *next = {vertex, which % 2 == 0 ? 1.f : -1.f, &last[which]};
            next += last[which].time != kNever;
        }
    }
    const auto count = static_cast<int>(next - those_.data()), filled_up = fit::filled_up(count);
    extent.flips = count;
    find_order(time, count);
    flipped_.resize(extent.flip + static_cast<std::size_t>(count));
    numbers_.resize(extent.number + 5 * static_cast<std::size_t>(filled_up));
    int* const flipped = flipped_.data() + extent.flip;
    double* const x = numbers_.data() + extent.number;
    double *const y = x + filled_up, *const age = y + filled_up, *const east = age + filled_up;
    double* const north = east + filled_up;
    for (int i = 0; i < count; ++i) {
        const auto& [vertex, way, flip] = those_[i];
        const int at = order_[i];
        flipped[at] = vertex;
        x[at] = mesh.position[vertex].x, y[at] = mesh.position[vertex].y;
        age[at] = time - flip->time;
        east[at] = way * flip->direction.x, north[at] = way * flip->direction.y;
    }
}

// Finds the rank of each of those_ by age. For a few dozen it is fastest to compare each with all others,
// without a branch. A key is the age with the index in its last bits, so that no two are equal. Ages that
// differ only in those bits are as good as equal.
void OneSidedNeighbourhoods::find_order(double time, int count) {
    const std::uint32_t numbers = std::bit_ceil(static_cast<std::uint32_t>(count)) - 1;
    keys_.resize(count), order_.resize(count);
    for (int i = 0; i < count; ++i) {
        const auto age = std::bit_cast<std::uint32_t>(static_cast<float>(time - those_[i].flip->time));
        keys_[i] = static_cast<int>((age & ~numbers) | static_cast<std::uint32_t>(i));
    }
    kernels_.find_order(keys_.data(), count, order_.data());
}

}  // namespace sim::front
