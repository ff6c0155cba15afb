#include "render/flow/flow_changes.h"

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
    if (all) {
        remember(flow);
    } else {
        compare_groups(flow);
        compare_crossings(flow);
        compare_gradients(flow.layers());
        describe_again(flow);
        finish_lists();
    }
    number_beside(flow.layers());
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
    is_near_.assign(count_, 0);
    differs_.assign(groups, 0);
    ranges_.reserve(groups);
    for (std::vector<int>* list : {&changed_, &repainted_, &near_, &beside_}) {
        list->clear();
        list->reserve(count_);
    }
    gradients_.reserve(count_ / 4);  // more than any flow needs
    crossings_.reserve(count_);
}

void FlowChanges::remember(const FlowView& flow) {
    const TextureLayers& layers = flow.layers();
    offsets_.assign(layers.offsets().begin(), layers.offsets().end());
    mixes_.assign(layers.mix().begin(), layers.mix().end());
    touched_.assign(layers.touched().begin(), layers.touched().end());
    vertices_.resize(count_);
    describe(flow, vertices_);
    changed_.resize(count_);
    std::iota(changed_.begin(), changed_.end(), 0);
    std::fill(differs_.begin(), differs_.end(), std::uint8_t{1});
    gradients_changed_ = true;
}

// Where nothing moved until now nor until the last call, nothing changed.
void FlowChanges::compare_groups(const FlowView& flow) {
    const std::span<const std::uint8_t> touched = flow.layers().touched();
    for (std::size_t group = 0; group < touched.size(); ++group) {
        if ((touched[group] | touched_[group]) != 0) compare_in(group, flow);
        touched_[group] = touched[group];
    }
}

void FlowChanges::compare_in(std::size_t group, const FlowView& flow) {
    const TextureLayers& layers = flow.layers();
    const std::size_t first = group * kVerticesInGroup, end = std::min(first + kVerticesInGroup, count_);
    if (!same_bytes(&layers.offsets()[first], &offsets_[first], end - first) ||
        !same_bytes(&layers.mix()[first], &mixes_[first], end - first))
        for (std::size_t v = first; v < end; ++v) {
            if (same_bytes(&layers.offsets()[v], &offsets_[v], 1) &&
                same_bytes(&layers.mix()[v], &mixes_[v], 1))
                continue;
            offsets_[v] = layers.offsets()[v];
            mixes_[v] = layers.mix()[v];
            is_repainted_[v] = 1;
            repainted_.push_back(static_cast<int>(v));
            add(static_cast<int>(v));
            add_near(static_cast<int>(v));
            differs_[group] = 1;
        }
    for (int v = static_cast<int>(first); v < static_cast<int>(end); ++v) {
        const float deposit = flow.deposit(v);
        if (same_bytes(&deposit, &vertices_[v].deposit, 1)) continue;
        vertices_[v].deposit = deposit;
        add(v);
        add_near(v);
        differs_[group] = 1;
    }
}

// Describes again the vertices within two edges of a change: what one shows depends on its neighbours, and its stretch on
// what they show.
void FlowChanges::describe_again(const FlowView& flow) {
    for (std::size_t ring = 0, first = 0; ring < 2; ++ring) {
        const std::size_t end = near_.size();
        for (; first < end; ++first)
            for (const auto& spoke : flow.mesh().around(near_[first])) add_near(spoke.vertex);
    }
    for (const int v : near_) {
        const int shows = shown_at(flow, vertices_, v);
        if (shows != vertices_[v].shows) {
            vertices_[v].shows = shows;
            add(v);
            mark_group(v);
        }
        if (is_repainted_[shows] != 0) add(v);
    }
    for (const int v : near_) {
        const float stretch = stretch_at(flow, vertices_, v);
        if (same_bytes(&stretch, &vertices_[v].stretch, 1)) continue;
        vertices_[v].stretch = stretch;
        add(v);
        mark_group(v);
    }
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
            for (const int v : {edges[edge].a, edges[edge].b}) {
                add(v);
                add_near(v);  // a neighbour across a front does not count
            }
        });
}

void FlowChanges::number_beside(const TextureLayers& layers) {
    const std::span<const int> beside = layers.beside_front();
    if (std::ranges::equal(beside, beside_)) return;
    for (const int v : beside_) {
        vertices_[v].beside = -1;
        mark_group(v);
    }
    for (std::size_t i = 0; i < beside.size(); ++i) {
        vertices_[beside[i]].beside = static_cast<int>(i);
        mark_group(beside[i]);
    }
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

void FlowChanges::add_near(int vertex) {
    if (is_near_[vertex] != 0) return;
    is_near_[vertex] = 1;
    near_.push_back(vertex);
}

void FlowChanges::mark_group(int vertex) {
    differs_[static_cast<std::size_t>(vertex) / kVerticesInGroup] = 1;
}

void FlowChanges::finish_lists() {
    for (const int v : changed_) is_changed_[v] = 0;
    for (const int v : repainted_) is_repainted_[v] = 0;
    for (const int v : near_) is_near_[v] = 0;
    repainted_.clear();
    near_.clear();
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
