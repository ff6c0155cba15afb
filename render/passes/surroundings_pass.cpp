#include "render/passes/surroundings_pass.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>

#include <glm/common.hpp>

#include "assets/shaders/slots.glsl"
#include "render/gl/program.h"
#include "render/gl/scissor.h"
#include "sim/core/check.h"

namespace render {

namespace {

// Mip-mapped, because a pixel of far mountains covers many vertices of the grid.
Texture make_cover_texture(const Surroundings& around) {
    const int columns = around.columns(), rows = around.rows();
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    glTextureStorage2D(name, std::bit_width(static_cast<unsigned>(std::max(columns, rows))), GL_RG16F,
                       columns, rows);
    glTextureSubImage2D(name, 0, 0, 0, columns, rows, GL_RG, GL_FLOAT, around.cover().data());
    glGenerateTextureMipmap(name);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return Texture(name);
}

}  // namespace

tl::expected<void, std::string> SurroundingsPass::load(const std::filesystem::path& shaders,
                                                       GroundKind kind) {
    if (programs_[kind]) return {};
    auto program = link_program(
        shaders, {{GL_VERTEX_SHADER, {"slots.glsl", "frame.glsl", "cover.glsl", "surroundings.vert"}},
                  {GL_FRAGMENT_SHADER,
                   {"slots.glsl", "frame.glsl", kind.dated ? "dated.glsl" : "undated.glsl", "cover.glsl",
                    "light.glsl", "ground.glsl", "plants.glsl", "surroundings.frag",
                    kind.two_materials ? "surroundings_two.glsl" : "surroundings_one.glsl"}}});
    if (!program) return tl::unexpected(program.error());
    programs_[kind] = std::move(*program);
    return {};
}

void SurroundingsPass::survey(const Surroundings& around, const FrameBlock& frame) {
    const bool is_new = known_ != around.fingerprint();
    if (is_new) {
        known_ = around.fingerprint();
        mesh_ = surroundings_mesh(around);
        vertex_array_ = make_vertex_array();
        vertices_ = make_buffer();
        indices_ = make_buffer();
        sunlit_buffer_ = make_buffer();
        const auto send = [](const Buffer& buffer, const auto& values) {
            glNamedBufferData(buffer.name(), static_cast<GLsizeiptr>(values.size() * sizeof values[0]),
                              values.data(), GL_STATIC_DRAW);
        };
        send(vertices_, mesh_.vertices);
        send(indices_, mesh_.indices);
        const GLuint array = vertex_array_.name();
        glVertexArrayElementBuffer(array, indices_.name());
        const auto attribute = [&](GLuint location, GLuint buffer, int components, std::size_t offset) {
            glEnableVertexArrayAttrib(array, location);
            glVertexArrayAttribFormat(array, location, components, GL_FLOAT, GL_FALSE,
                                      static_cast<GLuint>(offset));
            glVertexArrayAttribBinding(array, location, buffer);
        };
        using Vertex = SurroundingsVertex;
        glVertexArrayVertexBuffer(array, 0, vertices_.name(), 0, sizeof(Vertex));
        glVertexArrayVertexBuffer(array, 1, sunlit_buffer_.name(), 0, sizeof(float));
        attribute(0, 0, 3, offsetof(Vertex, at));
        attribute(1, 0, 4, offsetof(Vertex, slope));  // and source
        attribute(2, 0, 4, offsetof(Vertex, cover));  // openness, on grid
        attribute(3, 1, 1, 0);
        heights_ = make_texture(GL_R32F, Surroundings::kRough, Surroundings::kRough, GL_LINEAR);
        glTextureSubImage2D(heights_.name(), 0, 0, 0, Surroundings::kRough, Surroundings::kRough, GL_RED,
                            GL_FLOAT, around.rough_heights().data());
        cover_ = make_cover_texture(around);
        find_seams(static_cast<float>(around.cell()));
        counts_.reserve(mesh_.patches.size());
        firsts_.reserve(mesh_.patches.size());
        visible_.reserve(mesh_.patches.size());
        seen_.reserve(mesh_.patches.size());
        lowest_.reserve(mesh_.patches.size());
        highest_.reserve(mesh_.patches.size());
    }
    if (is_new || known_sun_ != frame.sun) {
        known_sun_ = frame.sun;
        sunlit(around, mesh_.vertices, glm::dvec3(frame.sun), sunlit_);
        glNamedBufferData(sunlit_buffer_.name(), static_cast<GLsizeiptr>(sunlit_.size() * sizeof(float)),
                          sunlit_.data(), GL_DYNAMIC_DRAW);
    }
}

void SurroundingsPass::bind() const {
    glBindTextureUnit(SLOT_SURROUNDINGS, heights_.name());
    glBindTextureUnit(SLOT_FIRST_COVER, cover_.name());
}

void SurroundingsPass::find_seams(float cell) {
    seams_.clear();
    for (std::size_t p = 0; p < mesh_.patches.size(); ++p) {
        const SurroundingsPatch& patch = mesh_.patches[p];
        for (std::uint32_t i = patch.first; i < patch.first + patch.count; i += 3) {
            Seam seam{{},
                      0,
                      glm::vec3(std::numeric_limits<float>::max()),
                      glm::vec3(std::numeric_limits<float>::lowest()),
                      p};
            for (std::uint32_t k = i; k < i + 3; ++k) {
                const SurroundingsVertex& v = mesh_.vertices[mesh_.indices[k]];
                if (v.on_grid > 0.5f) {
                    seam.on_grid[static_cast<std::size_t>(seam.corners++)] =
                        glm::ivec2(glm::round(glm::vec2(v.at) / cell));
                } else {
                    seam.lowest = glm::min(seam.lowest, v.at);
                    seam.highest = glm::max(seam.highest, v.at);
                }
            }
            if (seam.corners > 0) seams_.push_back(seam);
        }
    }
}

void SurroundingsPass::find(const Redraw& redraw) {
    if (redraw.everything)
        visible_patches(mesh_.patches, redraw.screen, glm::vec3(redraw.frame.eye), visible_);
    if (redraw.everything || !redraw.changed.moved().empty()) find_parts(redraw.changed, redraw.screen);
    if (redraw.everything) return;
    const float dx = redraw.changed.grid().dx;
    for (const Seam& seam : seams_) {
        glm::vec3 lowest = seam.lowest, highest = seam.highest;
        bool near = false;
        for (int k = 0; k < seam.corners; ++k) {
            const glm::ivec2 v = seam.on_grid[static_cast<std::size_t>(k)];
            const glm::vec2 at = dx * glm::vec2(v), heights = redraw.changed.heights_between(v, v);
            near |= redraw.changed.is_near(at, at);
            lowest = glm::min(lowest, glm::vec3(at, heights.x));
            highest = glm::max(highest, glm::vec3(at, heights.y));
        }
        if (near) redraw.tiles.mark(redraw.screen.box(lowest, highest));
    }
}

// Finds where each patch appears.
void SurroundingsPass::find_parts(const WhatChanged& changed, const OnScreen& screen) {
    lowest_.clear();
    highest_.clear();
    for (const SurroundingsPatch& patch : mesh_.patches) {
        lowest_.push_back(patch.lowest);
        highest_.push_back(patch.highest);
    }
    for (const Seam& seam : seams_)
        for (int k = 0; k < seam.corners; ++k) {
            const glm::ivec2 v = seam.on_grid[static_cast<std::size_t>(k)];
            const glm::vec2 heights = changed.heights_between(v, v);
            lowest_[seam.patch].z = std::min(lowest_[seam.patch].z, heights.x);
            highest_[seam.patch].z = std::max(highest_[seam.patch].z, heights.y);
        }
    seen_.clear();
    for (const SurroundingsPatch* patch : visible_) {
        const auto i = static_cast<std::size_t>(patch - mesh_.patches.data());
        seen_.push_back(screen.box(lowest_[i], highest_[i]));
    }
}

void SurroundingsPass::draw(GroundKind kind, std::span<const Rectangle> parts) {
    CHECK(programs_[kind]);
    const Enabled depth_test(GL_DEPTH_TEST), cull_face(GL_CULL_FACE), scissors(GL_SCISSOR_TEST);
    glUseProgram(programs_[kind]->name());
    glBindVertexArray(vertex_array_.name());
    for (const Rectangle& part : parts) {
        counts_.clear();
        firsts_.clear();
        for (std::size_t i = 0; i < visible_.size(); ++i) {
            if (!part.meets(seen_[i])) continue;
            counts_.push_back(static_cast<GLsizei>(visible_[i]->count));
            firsts_.push_back(in_buffer(visible_[i]->first * sizeof(std::uint32_t)));
        }
        scissor(part);
        glMultiDrawElements(GL_TRIANGLES, counts_.data(), GL_UNSIGNED_INT, firsts_.data(),
                            static_cast<GLsizei>(counts_.size()));
    }
}

}  // namespace render
