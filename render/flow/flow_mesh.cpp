#include "render/flow/flow_mesh.h"

#include <algorithm>

#include "sim/core/check.h"

namespace render {
namespace {

using sim::front::CutTriangle;
using sim::front::CutVertex;
using sim::front::FlowView;
using sim::front::TextureLayers;

// What flow.vert sees of a deposit, of which the surface has steps (FlowTriangles).
constexpr float kSeenDeposit = 0.001f, kSeenRise = 0.0018f;  // m

}  // namespace

void FlowMesh::make(const FlowView& flow, const sim::View& world, std::span<const float> first_depth,
                    const Look& look) {
    const sim::front::Mesh& mesh = flow.mesh();
    CHECK(mesh.columns == world.grid.nx && mesh.position.size() == world.grid.size());
    changes_.find(flow);
    triangles_.find(world, first_depth, changes_.vertices(), look);
    const auto nx = static_cast<std::size_t>(world.grid.nx);
    place_.assign(mesh.position.size(), -1);
    deposit_.resize(mesh.position.size());
    seen_.resize(mesh.position.size());
    for (std::size_t v = 0; v < deposit_.size(); ++v) {
        const int x = static_cast<int>(v % nx), y = static_cast<int>(v / nx);
        const float rise = first_depth.empty() ? 0 : world.depth(x, y) - first_depth[v];
        deposit_[v] = std::max(changes_.vertices()[v].deposit, rise > kSeenRise ? rise : 0);
        seen_[v] = look.flow->everywhere || world.rolling(x, y) > look.rolling_visible_m ||
                           deposit_[v] > kSeenDeposit
                       ? 1
                       : 0;
    }
    vertices_.clear();
    indices_.clear();
    for (const TriangleRun& run : triangles_.runs())
        for (int triangle = run.first; triangle < run.last; ++triangle)
            for (const CutTriangle& piece : cut_triangle(flow.tracker(), triangle)) add(flow, piece);
}

void FlowMesh::add(const FlowView& flow, const CutTriangle& triangle) {
    if (std::ranges::none_of(triangle, [&](const CutVertex& vertex) {
            return seen_[static_cast<std::size_t>(vertex.side)] != 0;
        }))
        return;
    for (const CutVertex& vertex : triangle) indices_.push_back(place_of(flow, vertex));
}

std::uint32_t FlowMesh::place_of(const FlowView& flow, const CutVertex& vertex) {
    const auto side = static_cast<std::size_t>(vertex.side);
    if (!vertex.on_front && place_[side] >= 0) return static_cast<std::uint32_t>(place_[side]);
    const auto place = static_cast<std::uint32_t>(vertices_.size());
    if (!vertex.on_front) place_[side] = static_cast<std::int32_t>(place);

    const FlowVertex& described = changes_.vertices()[side];
    const TextureLayers& layers = flow.layers();
    const auto shows = static_cast<std::size_t>(described.shows);
    FlowMeshVertex made{vertex.position, layers.offsets()[shows], layers.mix()[shows], described.stretch,
                        deposit_[side]};
    if (vertex.on_front && described.beside >= 0) {
        const glm::vec2 way = vertex.position - flow.mesh().position[side];
        const TextureLayers::Gradients& gradients =
            layers.gradients()[static_cast<std::size_t>(described.beside)];
        for (std::size_t sheet = 0; sheet < gradients.size(); ++sheet)
            made.offset[sheet] += gradients[sheet] * way;
    }
    vertices_.push_back(made);
    return place;
}

}  // namespace render
