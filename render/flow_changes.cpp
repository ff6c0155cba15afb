#include "render/flow_changes.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "sim/core/check.h"

namespace render {
namespace {

using sim::front::FlowView;
using sim::front::Mesh;
using sim::front::TextureLayers;

constexpr std::size_t kVerticesInGroup = TextureLayers::kGroup;
// Ranges with fewer groups between them are joined, because each upload has a cost of its own.
constexpr std::size_t kGroupsJoined = 8;

template <class T>
bool same_bytes(const T* a, const T* b, std::size_t count) {
    return std::memcmp(a, b, count * sizeof(T)) == 0;
}

// `beside` is only an index: what it stands for is compared with the gradients.
bool drawn_alike(const FlowVertex& a, const FlowVertex& b) {
    return a.shows == b.shows && same_bytes(&a.deposit, &b.deposit, 1) &&
           same_bytes(&a.stretch, &b.stretch, 1);
}

// Visits the keys that only one of two ascending lists has, or that `differ(i, j)`.
template <class A, class B, class Key, class Differ, class Visit>
void merge(const A& a, const B& b, const Key& key, const Differ& differ, const Visit& visit) {
    std::size_t i = 0, j = 0;
    while (i < a.size() || j < b.size()) {
        if (j == b.size() || (i < a.size() && key(a[i]) < key(b[j]))) {
            visit(key(a[i++]));
        } else if (i == a.size() || key(b[j]) < key(a[i])) {
            visit(key(b[j++]));
        } else {
            if (differ(i, j)) visit(key(a[i]));
            ++i, ++j;
        }
    }
}

}  // namespace

void FlowChanges::find(const FlowView& flow) {
    const Mesh& mesh = flow.mesh();
    CHECK(mesh.columns > 0);
    const bool all = is_new(mesh);
    if (all) begin(mesh);
    changed_.clear();
    vertices_.describe(flow);
    if (all) {
        remember(flow);
    } else {
        compare_groups(flow.layers());
        compare_others();
        compare_gradients(flow.layers());
        compare_crossings(flow);
        sort_changed();
    }
    remember_fronts(flow);
    find_ranges();
}

// A heightfield's columns, number of vertices and last vertex determine it.
bool FlowChanges::is_new(const Mesh& mesh) const {
    return columns_ != mesh.columns || count_ != mesh.position.size() || end_ != mesh.position.back();
}

void FlowChanges::begin(const Mesh& mesh) {
    columns_ = mesh.columns;
    count_ = mesh.position.size();
    end_ = mesh.position.back();
    const std::size_t groups = (count_ + kVerticesInGroup - 1) / kVerticesInGroup;
    is_changed_.assign(count_, 0);
    is_repainted_.assign(count_, 0);
    repainted_.clear();
    differs_.assign(groups, 0);
    ranges_.reserve(groups);
    for (std::vector<int>* list : {&changed_, &repainted_, &beside_}) list->reserve(count_);
    gradients_.reserve(count_ / 4);  // more than any flow needs
    crossings_.reserve(count_);
}

void FlowChanges::remember(const FlowView& flow) {
    const TextureLayers& layers = flow.layers();
    offsets_.assign(layers.offsets().begin(), layers.offsets().end());
    mixes_.assign(layers.mix().begin(), layers.mix().end());
    values_.assign(vertices_.values().begin(), vertices_.values().end());
    changed_.resize(count_);
    std::iota(changed_.begin(), changed_.end(), 0);
    std::fill(differs_.begin(), differs_.end(), std::uint8_t{1});
    gradients_changed_ = true;
}

void FlowChanges::compare_groups(const TextureLayers& layers) {
    for (const int v : repainted_) is_repainted_[v] = 0;
    repainted_.clear();
    for (const int g : vertices_.groups()) {
        const auto group = static_cast<std::size_t>(g), first = group * kVerticesInGroup;
        const std::size_t size = std::min(kVerticesInGroup, count_ - first);
        differs_[group] = !same_bytes(&layers.offsets()[first], &offsets_[first], size) ||
                          !same_bytes(&layers.mix()[first], &mixes_[first], size) ||
                          !same_bytes(&vertices_.values()[first], &values_[first], size);
        if (differs_[group] != 0) compare_in(group, layers);
    }
}

void FlowChanges::compare_in(std::size_t group, const TextureLayers& layers) {
    const std::size_t first = group * kVerticesInGroup, end = std::min(first + kVerticesInGroup, count_);
    for (std::size_t v = first; v < end; ++v) {
        const bool repainted = !same_bytes(&layers.offsets()[v], &offsets_[v], 1) ||
                               !same_bytes(&layers.mix()[v], &mixes_[v], 1);
        if (repainted) {
            offsets_[v] = layers.offsets()[v];
            mixes_[v] = layers.mix()[v];
            is_repainted_[v] = 1;
            repainted_.push_back(static_cast<int>(v));
        }
        if (repainted || !drawn_alike(vertices_.values()[v], values_[v])) add(static_cast<int>(v));
        values_[v] = vertices_.values()[v];
    }
}

void FlowChanges::compare_others() {
    for (const std::span<const int> list : vertices_.others())
        for (const int v : list) {
            const FlowVertex& now = vertices_.values()[v];
            if (same_bytes(&now, &values_[v], 1)) continue;
            differs_[static_cast<std::size_t>(v) / kVerticesInGroup] = 1;
            if (!drawn_alike(now, values_[v])) add(v);
            values_[v] = now;
        }
    for (const int v : vertices_.guests())
        if (is_repainted_[vertices_.values()[v].shows] != 0) add(v);
}

void FlowChanges::compare_gradients(const TextureLayers& layers) {
    gradients_changed_ = false;
    merge(
        layers.beside_front(), beside_, [](int v) { return v; },
        [&](std::size_t i, std::size_t j) { return !same_bytes(&layers.gradients()[i], &gradients_[j], 1); },
        [&](int v) {
            gradients_changed_ = true;
            add(v);
        });
}

void FlowChanges::compare_crossings(const FlowView& flow) {
    const std::vector<sim::front::Mesh::Edge>& edges = flow.mesh().edge;
    const std::span<const sim::front::Point> points = flow.tracker().points();
    merge(
        points, crossings_, [](const auto& on) { return on.edge; },
        [&](std::size_t i, std::size_t j) { return !same_bytes(&points[i].f, &crossings_[j].at, 1); },
        [&](int edge) {
            add(edges[edge].a);
            add(edges[edge].b);
        });
}

void FlowChanges::remember_fronts(const FlowView& flow) {
    const TextureLayers& layers = flow.layers();
    beside_.assign(layers.beside_front().begin(), layers.beside_front().end());
    gradients_.assign(layers.gradients().begin(), layers.gradients().end());
    crossings_.clear();
    for (const sim::front::Point& point : flow.tracker().points())
        crossings_.push_back({point.edge, point.f});
}

void FlowChanges::add(int vertex) {
    if (is_changed_[vertex] != 0) return;
    is_changed_[vertex] = 1;
    changed_.push_back(vertex);
}

void FlowChanges::sort_changed() {
    for (const int v : changed_) is_changed_[v] = 0;
    std::sort(changed_.begin(), changed_.end());
}

void FlowChanges::find_ranges() {
    ranges_.clear();
    std::size_t before = 0;  // end of the last group that differs
    for (std::size_t g = 0; g < differs_.size(); ++g) {
        if (differs_[g] == 0) continue;
        differs_[g] = 0;
        const auto first = static_cast<int>(g * kVerticesInGroup);
        const auto last = static_cast<int>(std::min((g + 1) * kVerticesInGroup, count_));
        if (!ranges_.empty() && g - before < kGroupsJoined)
            ranges_.back().last = last;
        else
            ranges_.push_back({first, last});
        before = g + 1;
    }
}

}  // namespace render
