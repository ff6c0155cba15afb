#include "render/passes/carried_pass.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "assets/shaders/slots.glsl"
#include "render/gl/program.h"
#include "render/gl/scissor.h"
#include "render/gl/scoped_state.h"

namespace render {
namespace {

// Vertices of so many vec4 each.
void describe(const VertexArray& array, const Buffer& buffer, GLuint attributes) {
    constexpr GLuint kSize = sizeof(glm::vec4);
    glVertexArrayVertexBuffer(array.name(), 0, buffer.name(), 0, static_cast<GLsizei>(attributes * kSize));
    for (GLuint location = 0; location < attributes; ++location) {
        glEnableVertexArrayAttrib(array.name(), location);
        glVertexArrayAttribFormat(array.name(), location, 4, GL_FLOAT, GL_FALSE, location * kSize);
        glVertexArrayAttribBinding(array.name(), location, 0);
    }
}

}  // namespace

tl::expected<CarriedPass, std::string> CarriedPass::create(const std::filesystem::path& shaders) {
    CarriedPass pass;
    for (auto& [program, stages] :
         {std::pair{&pass.program_,
                    std::vector<ShaderStage>{
                        {GL_VERTEX_SHADER,
                         {"slots.glsl", "frame.glsl", "light.glsl", "sun_ceiling.glsl", "carried.vert"}},
                        {GL_FRAGMENT_SHADER, {"slots.glsl", "frame.glsl", "light.glsl", "carried.frag"}}}},
          {&pass.shadow_program_,
           {{GL_VERTEX_SHADER,
             {"slots.glsl", "frame.glsl", "light.glsl", "sun_ceiling.glsl", "triangle_height.glsl",
              "carried_shadow.vert"}},
            {GL_FRAGMENT_SHADER, {"carried_shadow.frag"}}}}}) {
        auto linked = link_program(shaders, stages);
        if (!linked) return tl::unexpected(linked.error());
        *program = std::move(*linked);
    }
    return pass;
}

// Once, before anything is carried, so that no later frame allocates.
void CarriedPass::make_room() {
    if (has_room_) return;
    has_room_ = true;
    for (auto [array, buffer, vertices, attributes] :
         {std::tuple{&array_, &vertices_, CarriedInView::kMostVertices, 3u},
          std::tuple{&shadow_array_, &shadow_vertices_, 6 * sim::carried::Carried::kMost, 2u}}) {
        *array = make_vertex_array();
        *buffer = make_buffer();
        glNamedBufferStorage(buffer->name(),
                             static_cast<GLsizeiptr>(vertices * attributes * sizeof(glm::vec4)), nullptr,
                             GL_DYNAMIC_STORAGE_BIT);
        describe(*array, *buffer, attributes);
    }
    in_view_.reserve();
    known_.reserve(sim::carried::Carried::kMost);
    changed_.reserve(sim::carried::Carried::kMost);
    for (auto* each : {&firsts_, &shadow_firsts_}) each->reserve(sim::carried::Carried::kMost);
    for (auto* each : {&counts_, &shadow_counts_}) each->reserve(sim::carried::Carried::kMost);
}

void CarriedPass::send() {
    const auto send = [](const Buffer& to, const auto& vertices) {
        glNamedBufferSubData(to.name(), 0, static_cast<GLsizeiptr>(vertices.size_bytes()), vertices.data());
    };
    send(vertices_, in_view_.vertices());
    send(shadow_vertices_, in_view_.shadows());
}

void CarriedPass::find_changed(std::span<const sim::carried::Body> bodies) {
    changed_.assign(std::max(bodies.size(), known_.size()), 1);
    for (std::size_t i = 0; i < std::min(bodies.size(), known_.size()); ++i)
        changed_[i] = bodies[i] != known_[i];
    known_.assign(bodies.begin(), bodies.end());
}

void CarriedPass::mark(const CarriedInView& bodies, std::span<const std::uint8_t> changed,
                       ScreenTiles& tiles) const {
    for (const CarriedInView::InView& each : bodies.bodies())
        if (changed[each.body]) tiles.mark(each.seen);
}

void CarriedPass::find(const FrameInput& input, const Redraw& redraw) {
    const std::span<const sim::carried::Body> bodies =
        input.may_have_carried() ? input.carried : std::span<const sim::carried::Body>();
    if (input.may_have_carried()) make_room();
    if (bodies.empty() && known_.empty()) return;
    find_changed(bodies);
    const bool moved = std::ranges::find(changed_, 1) != changed_.end();
    if (redraw.everything || moved) {
        if (!redraw.everything) mark(in_view_, changed_, redraw.tiles);  // what the last frame showed
        in_view_.find(bodies, redraw.frame, redraw.screen);
        if (!in_view_.empty()) send();
    }
    if (redraw.everything) return;
    mark(in_view_, changed_, redraw.tiles);
    for (const CarriedInView::InView& each : in_view_.bodies()) {
        const sim::carried::Body& body = bodies[each.body];
        const float reach = CarriedInView::reach(body, redraw.frame);
        if (redraw.changed.is_near(glm::vec2(body.at) - reach, glm::vec2(body.at) + reach))
            redraw.tiles.mark(each.seen);
    }
}

// Lists the bodies of a part.
void CarriedPass::list(const Rectangle& part) {
    firsts_.clear(), counts_.clear(), shadow_firsts_.clear(), shadow_counts_.clear();
    for (const CarriedInView::InView& each : in_view_.bodies()) {
        if (!part.meets(each.seen)) continue;
        firsts_.push_back(static_cast<GLint>(each.first));
        counts_.push_back(static_cast<GLsizei>(each.count));
        shadow_firsts_.push_back(static_cast<GLint>(each.first_of_shadow));
        shadow_counts_.push_back(6);
    }
}

void CarriedPass::draw(std::span<const Rectangle> parts) {
    const Enabled depth_test(GL_DEPTH_TEST), scissors(GL_SCISSOR_TEST);
    const auto draw = [&](const ProgramName& program, const VertexArray& array, const auto& firsts,
                          const auto& counts) {
        glUseProgram(program.name());
        glBindVertexArray(array.name());
        glMultiDrawArrays(GL_TRIANGLES, firsts.data(), counts.data(), static_cast<GLsizei>(firsts.size()));
    };
    for (const Rectangle& part : parts) {
        list(part);
        if (firsts_.empty()) continue;
        scissor(part);
        {
            // A shadow lies on the ground as a rectangle, which is a little above it.
            const Enabled blend(GL_BLEND), offset(GL_POLYGON_OFFSET_FILL);
            glPolygonOffset(2, 256);
            glDepthMask(GL_FALSE);
            glBlendFunc(GL_ZERO, GL_SRC_COLOR);
            draw(shadow_program_, shadow_array_, shadow_firsts_, shadow_counts_);
            glBlendFunc(GL_ONE, GL_ZERO);
            glDepthMask(GL_TRUE);
            glPolygonOffset(0, 0);
        }
        const Enabled cull_face(GL_CULL_FACE);
        draw(program_, array_, firsts_, counts_);
    }
}

}  // namespace render
