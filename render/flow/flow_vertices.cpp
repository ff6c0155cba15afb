#include "render/flow/flow_vertices.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "assets/shaders/slots.glsl"
#include "render/base/ramp.h"
#include "sim/core/check.h"

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

}  // namespace

void describe(const FlowView& flow, std::span<FlowVertex> vertices) {
    const int count = flow.mesh().vertices();
    CHECK(vertices.size() == flow.mesh().position.size());
    for (int v = 0; v < count; ++v) vertices[v] = {-1, flow.deposit(v), v, 0};
    for (int v = 0; v < count; ++v) vertices[v].shows = shown_at(flow, vertices, v);
    for (int v = 0; v < count; ++v) vertices[v].stretch = stretch_at(flow, vertices, v);
    const std::span<const int> beside = flow.layers().beside_front();
    for (std::size_t i = 0; i < beside.size(); ++i) vertices[beside[i]].beside = static_cast<int>(i);
}

int shown_at(const FlowView& flow, std::span<const FlowVertex> vertices, int vertex) {
    int shown = vertex;
    if (!flow.layers().has_moved(vertex))
        for (const auto& spoke : flow.mesh().around(vertex))
            if (vertices[spoke.vertex].deposit > 0) shown = spoke.vertex;
    return shown;
}

float stretch_at(const FlowView& flow, std::span<const FlowVertex> vertices, int vertex) {
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

float kept_share(float stretch) {
    constexpr auto kKept = static_cast<float>(STRETCH_KEPT), kGone = static_cast<float>(STRETCH_GONE);
    return ramp(kGone, kKept, stretch);
}

}  // namespace render
