#include "render/passes/flow_pass.h"

#include <algorithm>
#include <initializer_list>
#include <utility>
#include <vector>

#include "assets/shaders/slots.glsl"
#include "render/gl/program.h"
#include "render/gl/scissor.h"
#include "sim/core/check.h"

namespace render {
namespace {

// Offsets depth toward the camera, so that the surface, drawn earlier with other triangles of the same
// heights, does not hide the flow. Depth is reversed.
constexpr float kOffsetBySlope = 1, kOffset = 64;

}  // namespace

tl::expected<FlowPass, std::string> FlowPass::create(const std::filesystem::path& shaders) {
    auto remesher = Remesher::create(shaders);
    if (!remesher) return tl::unexpected(remesher.error());
    FlowPass pass;
    pass.remesher_ = std::move(*remesher);

    const auto on_surface = [](std::string_view file) {
        return ShaderStage{GL_VERTEX_SHADER,
                           {"slots.glsl", "frame.glsl", "cut_vertex.glsl", "triangle_height.glsl", file}};
    };
    const auto painted = [&](std::vector<std::string_view> files) {
        files.insert(files.begin(), {"slots.glsl", "frame.glsl", "flow.frag"});
        return std::vector<ShaderStage>{on_surface("flow.vert"), {GL_FRAGMENT_SHADER, files}};
    };
    for (auto [program, stages] : std::initializer_list<std::pair<ProgramName*, std::vector<ShaderStage>>>{
             {&pass.blended_, painted({"grain.glsl", "turf_none.glsl", "paint_blended.glsl"})},
             {&pass.blended_with_turf_, painted({"grain.glsl", "turf.glsl", "paint_blended.glsl"})},
             {&pass.chosen_, painted({"grain.glsl", "turf_none.glsl", "paint_chosen.glsl"})},
             {&pass.stretch_, painted({"tone_curve.glsl", "turf_none.glsl", "paint_stretch.glsl"})},
             {&pass.mesh_program_, {on_surface("flow_mesh.vert"), {GL_FRAGMENT_SHADER, {"flow_mesh.frag"}}}},
             {&pass.point_program_,
              {on_surface("flow_points.vert"),
               {GL_FRAGMENT_SHADER, {"slots.glsl", "frame.glsl", "flow_points.frag"}}}},
         }) {
        auto linked = link_program(shaders, stages);
        if (!linked) return tl::unexpected(linked.error());
        *program = std::move(*linked);
    }
    pass.no_vertices_ = make_vertex_array();
    std::array<float, 2> widths{};
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, widths.data());
    pass.widest_line_ = widths[1];
    return pass;
}

tl::expected<void, std::string> FlowPass::load(const std::filesystem::path& assets, FlowPattern pattern) {
    if (has(pattern)) return {};
    auto loaded = FlowTexture::load(assets, pattern);
    if (!loaded) return tl::unexpected(loaded.error());
    textures_[static_cast<std::size_t>(pattern)] = std::move(*loaded);
    return {};
}

void FlowPass::cut(const sim::front::FlowView& flow, const sim::Grid& grid) {
    CHECK(flow.mesh().columns == grid.nx && flow.mesh().position.size() == grid.size());
    if (grid_ != grid) {
        grid_ = grid;
        edges_ = flow.mesh().edges();
        remesher_.send_mesh(flow.mesh());
    }
    remesher_.cut(flow.tracker().points());
}

void FlowPass::find_changes(const FlowTriangles& triangles, WhatChanged& changed) const {
    changed.add_flow(coordinates_.changed(), triangles.shown(), triangles.shown_before());
}

// Cuts runs into pieces short enough to be drawn only where they appear.
void FlowPass::find(std::span<const TriangleRun> triangles, const WhatChanged& changed,
                    const OnScreen& screen) {
    constexpr int kMostTriangles = 16;
    const int along = 2 * (grid_->nx - 1);  // triangles of a row
    const float dx = grid_->dx;
    pieces_.clear();
    for (const TriangleRun& run : triangles)
        for (int first = run.first; first < run.last;) {
            const int row = first / along;
            const int last = std::min({first + kMostTriangles, (row + 1) * along, run.last});
            const glm::ivec2 low(first % along / 2, row), high((last - 1) % along / 2 + 1, row + 1);
            const glm::vec2 heights = changed.heights_between(low, high);
            const Rectangle seen =
                screen.box({dx * glm::vec2(low), heights.x}, {dx * glm::vec2(high), heights.y});
            if (!seen.empty()) pieces_.push_back({{first, last}, &run, seen});
            first = last;
        }
}

void FlowPass::resize(const Target& target) {
    if (width_ == target.samples_across() && height_ == target.samples_up()) return;
    width_ = target.samples_across(), height_ = target.samples_up();
    albedo_ = make_texture(GL_RGBA16F, width_, height_, GL_NEAREST);
    relief_ = make_texture(GL_RGBA16F, width_, height_, GL_NEAREST);
    framebuffer_ = make_framebuffer();
    glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, albedo_.name(), 0);
    glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT1, relief_.name(), 0);
    constexpr std::array<GLenum, 2> kBoth{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glNamedFramebufferDrawBuffers(framebuffer_.name(), kBoth.size(), kBoth.data());
}

void FlowPass::draw(const Look& look, Overlay overlay, const Target& target, Target::Parts parts) {
    const FlowPattern pattern = look.flow->pattern;
    CHECK(has(pattern));
    resize(target);
    target.lend_depth(framebuffer_.name());
    constexpr std::array<float, 4> kNothing{0, 0, 0, 0};
    within(parts, [&] {
        glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 0, kNothing.data());
        glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 1, kNothing.data());
    });
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());

    texture(pattern)->bind();
    const ProgramName& blended = look.date ? blended_with_turf_ : blended_;
    glUseProgram((overlay == Overlay::kStretch   ? stretch_
                  : texture(pattern)->stochastic ? blended
                                                 : chosen_)
                     .name());
    const Enabled depth_test(GL_DEPTH_TEST), cull_face(GL_CULL_FACE), nearer(GL_POLYGON_OFFSET_FILL),
        scissors(GL_SCISSOR_TEST);
    glPolygonOffset(kOffsetBySlope, kOffset);
    glDepthMask(GL_FALSE);
    remesher_.bind();
    coordinates_.bind();
    Rectangle around;
    for (const Rectangle& part : parts) {
        around = around_both(around, part);
        runs_.clear();
        const TriangleRun* run = nullptr;
        for (const Piece& piece : pieces_) {
            if (!part.meets(piece.seen)) continue;
            // A few triangles between two pieces of a run cost less than another run.
            if (run == piece.of)
                FlowTriangles::append(runs_, piece.run);
            else
                runs_.push_back(piece.run);
            run = piece.of;
        }
        scissor(part);
        remesher_.draw_first_pieces(runs_);
    }
    // Where further pieces lie is not known here. What they draw between the parts is the same again.
    if (!around.empty()) {
        scissor(around);
        remesher_.draw_further_pieces();
    }
    glDepthMask(GL_TRUE);
    glPolygonOffset(0, 0);
    glBindTextureUnit(SLOT_SKIN_ALBEDO, albedo_.name());
    glBindTextureUnit(SLOT_SKIN_RELIEF, relief_.name());
}

void FlowPass::draw_mesh(int samples) const {
    const Enabled depth_test(GL_DEPTH_TEST), blend(GL_BLEND), nearer(GL_POLYGON_OFFSET_LINE),
        point_size(GL_PROGRAM_POINT_SIZE);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glPolygonOffset(kOffsetBySlope, kOffset);
    glDepthMask(GL_FALSE);
    remesher_.bind();

    // Draw edges one pixel wide, then fronts over them, as wide as this GL allows.
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glUseProgram(mesh_program_.name());
    for (const bool fronts_alone : {false, true}) {
        glUniform1i(0, fronts_alone);
        glLineWidth(std::min(static_cast<float>(samples * (fronts_alone ? 2 : 1)), widest_line_));
        remesher_.draw();
    }
    glLineWidth(1);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);

    // Draw points through hills, so that a front behind a hill can be followed.
    glDisable(GL_DEPTH_TEST);
    glUseProgram(point_program_.name());
    glBindVertexArray(no_vertices_.name());
    glDrawArrays(GL_POINTS, 0, edges_);
    glDepthMask(GL_TRUE);
    glPolygonOffset(0, 0);
    glBlendFunc(GL_ONE, GL_ZERO);
}

}  // namespace render
