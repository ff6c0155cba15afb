#include "render/flow/flow_mesh.h"

#include <algorithm>

#include "sim/core/check.h"

namespace render {
namespace {

using sim::front::CutTriangle;
using sim::front::CutVertex;
using sim::front::FlowView;
using sim::front::TextureLayers;

}  // namespace

void FlowMesh::make(const FlowView& flow, const sim::View& world, std::span<const float> undisturbed,
                    const Look& look) {
    const sim::front::Mesh& mesh = flow.mesh();
    CHECK(mesh.columns == world.grid.nx && mesh.position.size() == world.grid.size());
    changes_.find(flow);
    triangles_.find(world, undisturbed, changes_.vertices(), look);
    place_.assign(mesh.position.size(), -1);
    vertices_.clear();
    indices_.clear();
    const auto is_seen = [&](const CutVertex& vertex) {
        return look.flow->everywhere || triangles_.seen()[static_cast<std::size_t>(vertex.side)] != 0;
    };
    const Moment moment{flow, world, undisturbed};
    for (const TriangleRun& run : triangles_.runs())
        for (int triangle = run.first; triangle < run.last; ++triangle)
            for (const CutTriangle& piece : cut_triangle(flow.tracker(), triangle))
                if (std::ranges::any_of(piece, is_seen))
                    for (const CutVertex& vertex : piece) indices_.push_back(place_of(vertex, moment));
}

// Vertices on a front are each triangle's own.
std::uint32_t FlowMesh::place_of(const CutVertex& vertex, const Moment& moment) {
    const auto side = static_cast<std::size_t>(vertex.side);
    if (!vertex.on_front && place_[side] >= 0) return static_cast<std::uint32_t>(place_[side]);
    const auto place = static_cast<std::uint32_t>(vertices_.size());
    if (!vertex.on_front) place_[side] = static_cast<std::int32_t>(place);

    const FlowVertex& described = changes_.vertices()[side];
    const TextureLayers& layers = moment.flow.layers();
    const auto shows = static_cast<std::size_t>(described.shows);
    FlowMeshVertex made{vertex.position, layers.offsets()[shows], layers.mix()[shows], described.stretch,
                        std::max(described.deposit, rise(vertex.side, moment))};
    if (vertex.on_front && described.beside >= 0) {
        const glm::vec2 way = vertex.position - moment.flow.mesh().position[side];
        const TextureLayers::Gradients& gradients =
            layers.gradients()[static_cast<std::size_t>(described.beside)];
        for (std::size_t sheet = 0; sheet < gradients.size(); ++sheet)
            made.offset[sheet] += gradients[sheet] * way;
    }
    vertices_.push_back(made);
    return place;
}

// As much of it as flow.vert sees.
float FlowMesh::rise(int vertex, const Moment& moment) {
    if (moment.undisturbed.empty()) return 0;
    const int nx = moment.world.grid.nx;
    const float rise =
        moment.world.depth(vertex % nx, vertex / nx) - moment.undisturbed[static_cast<std::size_t>(vertex)];
    return rise > FlowTriangles::kLeastRise ? rise : 0;
}

}  // namespace render
