#include "render/passes/structures_pass.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "assets/shaders/slots.glsl"
#include "render/gl/program.h"
#include "render/gl/scissor.h"

namespace render {
namespace {

// How far the surface within a part of the ground has risen or sunk since tick 0 at most, or lies beside it; m.
float largest_rise(const FrameInput& input, const WhatChanged& changed, glm::vec2 low, glm::vec2 high) {
    const sim::View& world = input.world;
    const glm::vec2 last(world.grid.nx - 1, world.grid.ny - 1);
    const glm::ivec2 from(glm::clamp(glm::floor(low / world.grid.dx), glm::vec2(0), last)),
        to(glm::clamp(glm::ceil(high / world.grid.dx), glm::vec2(0), last));
    float most = 0;
    for (int y = from.y; y <= to.y; ++y)
        for (int x = from.x; x <= to.x; ++x) {
            const float first =
                input.first_depth.empty()
                    ? 0
                    : input
                          .first_depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(world.grid.nx) +
                                       static_cast<std::size_t>(x)];
            const glm::vec2 heights = changed.heights_between({x, y}, {x, y}) - world.bedrock(x, y) - first;
            most = std::max({most, std::abs(heights.x), std::abs(heights.y)});
        }
    return most;
}

// Whether one of these vertices is so near that structures stand on it or cast a shadow on it.
bool is_near_any(const Structures& structures, std::span<const glm::ivec2> vertices, double dx) {
    constexpr double kNear = 140;  // m
    if (vertices.empty()) return false;
    glm::ivec2 low = vertices.front(), high = low;
    for (const glm::ivec2 v : vertices) low = glm::min(low, v), high = glm::max(high, v);
    const glm::dvec2 from = dx * glm::dvec2(low), to = dx * glm::dvec2(high);
    const auto near = [&](glm::dvec2 a, glm::dvec2 b) {
        return glm::all(glm::lessThanEqual(glm::min(a, b) - kNear, to)) &&
               glm::all(glm::greaterThanEqual(glm::max(a, b) + kNear, from));
    };
    if (std::ranges::any_of(structures.all, [&](const Structure& each) { return near(each.at, each.at); }))
        return true;
    if (std::ranges::any_of(structures.nets, [&](const Net& net) { return near(net.from, net.to); }))
        return true;
    return std::ranges::any_of(structures.roads, [&](const Road& road) {
        for (std::size_t i = 1; i < road.points.size(); ++i)
            if (near(road.points[i - 1], road.points[i])) return true;
        return false;
    });
}

}  // namespace

tl::expected<StructuresPass, std::string> StructuresPass::create(const std::filesystem::path& shaders) {
    StructuresPass pass;
    const std::vector<std::string_view> lit{"slots.glsl", "frame.glsl", "light.glsl", "sun_ceiling.glsl"};
    const auto with = [&](std::initializer_list<std::string_view> more) {
        std::vector<std::string_view> files = lit;
        files.insert(files.end(), more.begin(), more.end());
        return files;
    };
    for (auto& [program, stages] :
         {std::tuple{
              &pass.faces_program_,
              std::vector<ShaderStage>{{GL_VERTEX_SHADER, with({"triangle_height.glsl", "structure.vert"})},
                                       {GL_FRAGMENT_SHADER, {"slots.glsl", "frame.glsl", "structure.frag"}}}},
          {&pass.ropes_program_,
           {{GL_VERTEX_SHADER, with({"rope.vert"})}, {GL_FRAGMENT_SHADER, {"rope.frag"}}}},
          {&pass.shadows_program_,
           {{GL_VERTEX_SHADER, with({"triangle_height.glsl", "structure_shadow.vert"})},
            {GL_FRAGMENT_SHADER, {"structure_shadow.frag"}}}}}) {
        auto linked = link_program(shaders, stages);
        if (!linked) return tl::unexpected(linked.error());
        *program = std::move(*linked);
    }
    for (const auto& [vertices, attributes] :
         {std::pair{&pass.faces_, 4}, std::pair{&pass.ropes_, 2}, std::pair{&pass.shadows_, 2}}) {
        vertices->buffer = make_buffer();
        vertices->array = make_vertex_array();
        const GLuint array = vertices->array.name();
        const GLsizei size = attributes * static_cast<GLsizei>(sizeof(glm::vec4));
        glVertexArrayVertexBuffer(array, 0, vertices->buffer.name(), 0, size);
        for (GLuint location = 0; location < static_cast<GLuint>(attributes); ++location) {
            glEnableVertexArrayAttrib(array, location);
            glVertexArrayAttribFormat(array, location, 4, GL_FLOAT, GL_FALSE,
                                      location * static_cast<GLuint>(sizeof(glm::vec4)));
            glVertexArrayAttribBinding(array, location, 0);
        }
    }
    return pass;
}

void StructuresPass::build(const FrameInput& input, const FrameBlock& frame, bool new_terrain,
                           std::span<const glm::ivec2> moved) {
    rebuilt_ = false;
    if (!input.structures || input.structures->empty()) {
        rebuilt_ = !known_.empty();
        parts_.clear();
        shadow_vertices_.clear();
        ropes_.count = 0;
        known_ = {};
        return;
    }
    const glm::vec2 snow = snowy(input.look);
    const std::uint64_t around = input.surroundings ? input.surroundings->fingerprint() : 0;
    if (!new_terrain && !is_near_any(*input.structures, moved, input.world.grid.dx) &&
        around == known_around_ && snow == known_snowy_ && frame.sun == known_sun_ &&
        *input.structures == known_)
        return;
    rebuilt_ = true;
    known_ = *input.structures;
    known_sun_ = frame.sun;
    known_snowy_ = snow;
    known_around_ = around;
    const std::span<const glm::vec2> cover =
        input.surroundings ? input.surroundings->cover() : std::span<const glm::vec2>();
    send(structure_mesh(known_, {input.world, input.first_depth, cover, snow}, glm::vec3(frame.sun)));
}

void StructuresPass::send(const StructureMesh& mesh) {
    const auto fill = [](Vertices& into, const auto& vertices) {
        into.count = static_cast<GLsizei>(vertices.size());
        glNamedBufferData(into.buffer.name(), static_cast<GLsizeiptr>(vertices.size() * sizeof vertices[0]),
                          vertices.data(), GL_DYNAMIC_DRAW);
    };
    fill(faces_, mesh.faces);
    fill(ropes_, mesh.ropes);
    fill(shadows_, mesh.shadows);
    parts_ = mesh.parts;
    shadow_vertices_ = mesh.shadows;
    ropes_lowest_ = glm::vec3(std::numeric_limits<float>::max());
    ropes_highest_ = glm::vec3(std::numeric_limits<float>::lowest());
    for (const RopeVertex& v : mesh.ropes) {
        ropes_lowest_ = glm::min(ropes_lowest_, glm::vec3(v.at) - v.along.w);
        ropes_highest_ = glm::max(ropes_highest_, glm::vec3(v.at) + v.along.w);
    }
    in_view_.reserve(parts_.size());
    seen_.reserve(parts_.size());
    ranges_.reserve(parts_.size());
    firsts_.reserve(parts_.size());
    counts_.reserve(parts_.size());
}

void StructuresPass::find(const FrameInput& input, const Redraw& redraw) {
    const bool marks = rebuilt_ && !redraw.everything;
    if (marks) mark_all(redraw.tiles);  // what the last mesh showed
    if (parts_.empty() && ropes_.count == 0) {
        in_view_.clear(), seen_.clear(), ranges_.clear();
        shadows_seen_ = ropes_seen_ = {};
        return;
    }
    if (redraw.everything || rebuilt_ || !redraw.changed.moved().empty()) find_parts_in_view(input, redraw);
    if (marks) mark_all(redraw.tiles);
    if (redraw.everything || rebuilt_) return;
    for (std::size_t i = 0; i < in_view_.size(); ++i) {
        const glm::vec2 middle(in_view_[i]->middle);
        if (redraw.changed.is_near(middle - in_view_[i]->radius, middle + in_view_[i]->radius))
            redraw.tiles.mark(seen_[i]);
    }
    for (std::size_t i = 0; i + 2 < shadow_vertices_.size(); i += 3) {
        const glm::vec2 foot(shadow_vertices_[i].foot);
        bool near = redraw.changed.is_near(foot, foot);
        for (std::size_t k = i; k < i + 3; ++k)
            near |=
                redraw.changed.is_near(glm::vec2(shadow_vertices_[k].at), glm::vec2(shadow_vertices_[k].at));
        if (near) redraw.tiles.mark(shadow_box(i, redraw));
    }
}

void StructuresPass::mark_all(ScreenTiles& tiles) const {
    for (const Rectangle& seen : seen_) tiles.mark(seen);
    tiles.mark(shadows_seen_);
    tiles.mark(ropes_seen_);
}

// Where a triangle of a shadow appears: it lies on the ground at its corners.
Rectangle StructuresPass::shadow_box(std::size_t first, const Redraw& redraw) const {
    constexpr float kAbove = 1;  // m; structure_shadow.vert lifts it by half of that
    glm::vec3 lowest(std::numeric_limits<float>::max()), highest(std::numeric_limits<float>::lowest());
    for (std::size_t k = first; k < first + 3; ++k) {
        const glm::vec2 at(shadow_vertices_[k].at), heights = redraw.changed.heights_in(at, at);
        lowest = glm::min(lowest, glm::vec3(at, heights.x));
        highest = glm::max(highest, glm::vec3(at, heights.y + kAbove));
    }
    return redraw.screen.box(lowest, highest);
}

void StructuresPass::find_parts_in_view(const FrameInput& input, const Redraw& redraw) {
    constexpr float kDetails = 0.9f;  // m; where a sample is larger, a part is drawn without them
    const glm::vec3 eye(redraw.frame.eye);
    in_view_.clear();
    seen_.clear();
    ranges_.clear();
    for (const StructurePart& part : parts_) {
        const bool far = glm::distance(part.middle, eye) * redraw.frame.material.y > kDetails;
        const StructurePart::Range& range = far ? part.far : part.near;
        if (range.count == 0) continue;
        // What rests on the surface has risen or sunk with it.
        const glm::vec2 middle(part.middle);
        const float moved = largest_rise(input, redraw.changed, middle - part.radius, middle + part.radius);
        const Rectangle seen = redraw.screen.ball(part.middle, part.radius + moved);
        if (seen.empty()) continue;
        in_view_.push_back(&part);
        seen_.push_back(seen);
        ranges_.push_back(range);
    }
    shadows_seen_ = ropes_seen_ = {};
    for (std::size_t i = 0; i + 2 < shadow_vertices_.size(); i += 3)
        shadows_seen_ = around_both(shadows_seen_, shadow_box(i, redraw));
    if (ropes_.count > 0)
        ropes_seen_ = grown(redraw.screen.box(ropes_lowest_, ropes_highest_), 1);  // a pixel wide at least
}

void StructuresPass::draw(std::span<const Rectangle> parts) {
    const Enabled depth_test(GL_DEPTH_TEST), scissors(GL_SCISSOR_TEST);
    glUseProgram(faces_program_.name());
    glBindVertexArray(faces_.array.name());
    for (const Rectangle& part : parts) {
        firsts_.clear();
        counts_.clear();
        for (std::size_t i = 0; i < seen_.size(); ++i)
            if (part.meets(seen_[i])) {
                firsts_.push_back(static_cast<GLint>(ranges_[i].first));
                counts_.push_back(static_cast<GLsizei>(ranges_[i].count));
            }
        if (firsts_.empty()) continue;
        scissor(part);
        glMultiDrawArrays(GL_TRIANGLES, firsts_.data(), counts_.data(), static_cast<GLsizei>(firsts_.size()));
    }
    const auto draw = [&](const ProgramName& program, const Vertices& vertices, const Rectangle& seen) {
        glUseProgram(program.name());
        glBindVertexArray(vertices.array.name());
        for (const Rectangle& part : parts) {
            if (!part.meets(seen)) continue;
            scissor(part);
            glDrawArrays(GL_TRIANGLES, 0, vertices.count);
        }
    };
    const Enabled blend(GL_BLEND);
    glDepthMask(GL_FALSE);
    {
        // A shadow lies on the ground as triangles, which are a little above it everywhere.
        const Enabled offset(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(2, 256);
        glBlendFunc(GL_ZERO, GL_SRC_COLOR);
        draw(shadows_program_, shadows_, shadows_seen_);
        glPolygonOffset(0, 0);
    }
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    draw(ropes_program_, ropes_, ropes_seen_);
    glBlendFunc(GL_ONE, GL_ZERO);
    glDepthMask(GL_TRUE);
}

}  // namespace render
