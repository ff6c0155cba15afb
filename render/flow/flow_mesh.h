#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "render/flow/flow_changes.h"
#include "render/flow/flow_triangles.h"
#include "sim/front/flow_view.h"

namespace render {

// A vertex of the cut mesh with all that flow.frag needs there.
struct FlowMeshVertex {
    glm::vec2 at{0};                              // m
    sim::front::TextureLayers::Offsets offset{};  // m
    sim::front::TextureLayers::Mix mixture;
    float stretch = 0;  // as FlowVertex has it
    float deposit = 0;  // m
};

// The triangles of a cut mesh that show a flow, for a page in a browser: WebGL has no shader that cuts a mesh, and none
// that looks into buffers. It does what cut_edges.comp, cut_triangles.comp and flow.vert do, by cut_triangle().
class FlowMesh {
  public:
    // As FlowTriangles::find(). `flow` is of the same moment as `world`, and its mesh the heightfield of its grid.
    void make(const sim::front::FlowView& flow, const sim::View& world, std::span<const float> undisturbed,
              const Look& look);

    std::span<const FlowMeshVertex> vertices() const { return vertices_; }
    std::span<const std::uint32_t> indices() const {
        return indices_;
    }  // three to a triangle, counter-clockwise

  private:
    struct Moment {
        const sim::front::FlowView& flow;
        const sim::View& world;
        std::span<const float> undisturbed;
    };
    std::uint32_t place_of(const sim::front::CutVertex& vertex, const Moment& moment);
    static float rise(int vertex, const Moment& moment);  // of the standing layer, m

    FlowChanges changes_;
    FlowTriangles triangles_;
    std::vector<std::int32_t> place_;  // of each vertex of the mesh among vertices_; −1: not yet
    std::vector<FlowMeshVertex> vertices_;
    std::vector<std::uint32_t> indices_;
};

}  // namespace render
