#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "render/base/triangle_run.h"
#include "render/flow/flow_triangles.h"
#include "render/frame/marks.h"
#include "render/frame/what_changed.h"
#include "render/gl/gl_handle.h"
#include "render/passes/flow_texture.h"
#include "render/passes/flow_to_gpu.h"
#include "render/passes/remesher.h"
#include "render/passes/target.h"
#include "render/view/look.h"
#include "sim/core/grid.h"
#include "sim/front/flow_view.h"

namespace render {

// Draws an advected flow texture: a mesh cut along its fronts, with textures on either side. Writes colour
// and relief of each sample first; they are lit with the terrain, once per pixel.
class FlowPass {
  public:
    static tl::expected<FlowPass, std::string> create(const std::filesystem::path& shaders);

    // Loads a pattern. Call it once before the pattern is drawn. Errors as in FlowTexture::load.
    tl::expected<void, std::string> load(const std::filesystem::path& assets, FlowPattern pattern);
    bool has(FlowPattern pattern) const { return texture(pattern).has_value(); }
    glm::vec3 mean_colour(FlowPattern pattern) const { return texture(pattern)->mean; }

    // Uploads the flow's texture coordinates.
    void send(const sim::front::FlowView& flow) { coordinates_.upload(flow); }
    // Cuts the mesh along its fronts. The flow's mesh is the heightfield of `grid`.
    void cut(const sim::front::FlowView& flow, const sim::Grid& grid);
    // Of the flow sent last: see FlowToGpu.
    const FlowToGpu& coordinates() const { return coordinates_; }
    // Adds to `changed` where the flow looks different, of squares in which `triangles` are or were.
    void find_changes(const FlowTriangles& triangles, WhatChanged& changed) const;
    // Finds where these triangles of the mesh appear, which are all that may show the flow.
    void find(std::span<const TriangleRun> triangles, const WhatChanged& changed, const OnScreen& screen);
    // Draws those that were found last, with the pattern of the look, in parts of `target`. Reads SLOT_RELIEF, SLOT_ROLLING, SLOT_LAYERS and its depth.
    // Writes SLOT_SKIN_ALBEDO and SLOT_SKIN_RELIEF and leaves them bound. Leaves another framebuffer bound.
    void draw(const Look& look, Overlay overlay, const Target& target, Target::Parts parts);
    // Draws edges, fronts and points onto the scene; `samples` is the number along the edge of a pixel.
    void draw_mesh(int samples) const;

  private:
    const std::optional<FlowTexture>& texture(FlowPattern pattern) const {
        return textures_[static_cast<std::size_t>(pattern)];
    }
    void resize(const Target& target);

    // Some triangles of a row of squares, and where they appear.
    struct Piece {
        TriangleRun run;
        const TriangleRun* of;  // which it is a part of
        Rectangle seen;
    };

    // Three variants, because shader code costs time even if its branch is not taken.
    ProgramName blended_, blended_with_turf_, chosen_, stretch_;
    ProgramName mesh_program_, point_program_;
    Remesher remesher_;
    FlowToGpu coordinates_;
    std::vector<Piece> pieces_;
    std::vector<TriangleRun> runs_;  // in one part
    std::array<std::optional<FlowTexture>, kFlowPatterns.size()> textures_;
    std::optional<sim::Grid> grid_;  // whose mesh was uploaded
    int edges_ = 0;
    float widest_line_ = 1;       // supported by this GL, samples
    int width_ = 0, height_ = 0;  // samples
    Texture albedo_, relief_;
    Framebuffer framebuffer_;
    VertexArray no_vertices_;
};

}  // namespace render
