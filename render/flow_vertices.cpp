#include "render/flow_vertices.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "assets/shaders/slots.glsl"
#include "render/ramp.h"

namespace render {
namespace {

using sim::front::FlowView;
using sim::front::TextureLayers;

// How far the textures of two vertices differ, by the mix of the first, m.
float apart(const TextureLayers& layers, int vertex, int other) {
    float sum = 0;
    for (int s = 0; s < TextureLayers::kSheets; ++s)
        if (const float weight = layers.weight(vertex, s); weight > 0)
            sum += weight * glm::length(layers.offsets()[other][s] - layers.offsets()[vertex][s]);
    return sum;
}

float stretch_at(const FlowView& flow, const std::vector<FlowVertex>& vertices, int vertex) {
    const sim::front::Mesh& mesh = flow.mesh();
    const TextureLayers& layers = flow.layers();
    if (!layers.has_moved(vertex)) return static_cast<float>(STRETCH_GONE);
    const int own = vertices[vertex].shows;
    float sum = 0;
    int count = 0;
    for (const auto& [neighbour, edge] : mesh.around(vertex)) {
        const int other = vertices[neighbour].shows;
        if (!layers.has_moved(other) || flow.tracker().detector().is_cut(edge)) continue;
        if (other != own) {
            const float stretch = apart(layers, own, other) / mesh.length[edge];
            sum += stretch * stretch;
        }
        ++count;
    }
    return count > 0 ? std::sqrt(sum / static_cast<float>(count)) : 0;
}

FlowVertex where_nothing_moved(int vertex) {
    return {-1, 0, vertex, static_cast<float>(STRETCH_GONE)};
}

}  // namespace

void FlowVertices::describe(const FlowView& flow) {
    begin(flow);
    find_deposit(flow);
    for_vertices([&](int v) { values_[v].stretch = stretch_at(flow, values_, v); });
    find_beside(flow);
}

// Lists the groups where anything moved until now or until the last call, and puts back what was described elsewhere.
void FlowVertices::begin(const FlowView& flow) {
    const std::span<const std::uint8_t> touched = flow.layers().touched();
    const std::size_t count = flow.mesh().position.size();
    guests_.swap(guests_before_);
    beside_.swap(beside_before_);
    if (values_.size() != count) {
        values_.resize(count);
        touched_before_.assign(touched.size(), 1);
        for (std::vector<int>* list : {&guests_, &guests_before_, &beside_, &beside_before_}) {
            list->clear();
            list->reserve(count);
        }
        groups_.reserve(touched.size());
    }
    groups_.clear();
    for (std::size_t g = 0; g < touched.size(); ++g) {
        if ((touched[g] | touched_before_[g]) != 0) groups_.push_back(static_cast<int>(g));
        touched_before_[g] = touched[g];
    }
    for (const std::vector<int>* list : {&guests_before_, &beside_before_})
        for (const int v : *list) values_[v] = where_nothing_moved(v);
    for_vertices([&](int v) {
        values_[v] = where_nothing_moved(v);
        values_[v].deposit = flow.deposit(v);
    });
}

// The deposit is extended by one vertex. Otherwise its texture would be stretched to that of untouched ground.
void FlowVertices::find_deposit(const FlowView& flow) {
    guests_.clear();
    for_vertices([&](int v) {
        if (values_[v].deposit <= 0) return;
        for (const auto& spoke : flow.mesh().around(v)) {
            const int guest = spoke.vertex;
            if (flow.layers().has_moved(guest)) continue;
            if (values_[guest].shows == guest) guests_.push_back(guest);
            values_[guest].shows = v;
        }
    });
}

void FlowVertices::find_beside(const FlowView& flow) {
    const std::span<const int> beside = flow.layers().beside_front();
    beside_.assign(beside.begin(), beside.end());
    for (std::size_t i = 0; i < beside.size(); ++i) values_[beside[i]].beside = static_cast<int>(i);
}

// Visits the vertices of the groups, ascending.
template <class Visit>
void FlowVertices::for_vertices(const Visit& visit) const {
    constexpr int kGroup = TextureLayers::kGroup;
    for (const int g : groups_) {
        const int end = std::min((g + 1) * kGroup, static_cast<int>(values_.size()));
        for (int v = g * kGroup; v < end; ++v) visit(v);
    }
}

float kept_share(float stretch) {
    constexpr auto kKept = static_cast<float>(STRETCH_KEPT), kGone = static_cast<float>(STRETCH_GONE);
    return ramp(kGone, kKept, stretch);
}

}  // namespace render
