#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "render/frame/redrawn.h"
#include "render/frame/what_changed.h"
#include "render/gl/gl_handle.h"
#include "render/mountain/surroundings.h"
#include "render/mountain/surroundings_mesh.h"
#include "render/view/frame_block.h"
#include "render/view/ground_kind.h"

namespace render {

// Draws the mountains around the block.
class SurroundingsPass {
  public:
    // Compiles what draw() needs for ground of this kind, if it has not yet. Errors name the shader file and line.
    tl::expected<void, std::string> load(const std::filesystem::path& shaders, GroundKind kind);

    // Computes and uploads what depends on the surroundings, and on the direction of the sun: a tenth of a second
    // and a few hundredths. Does nothing if both are known.
    void survey(const Surroundings& around, const FrameBlock& frame);
    void bind() const;  // SLOT_SURROUNDINGS: the rough heights; SLOT_FIRST_COVER
    // Finds what a camera sees and, if only the world changed, marks where the seam looks different: triangles with
    // corners on the grid.
    void find(const Redraw& redraw);
    // Draws colour and depth in parts of the frame, where nothing nearer was drawn. Reads SLOT_RELIEF, SLOT_LAYERS,
    // SLOT_MIXTURE, SLOT_DETAIL, SLOT_FIRST_COVER.
    void draw(GroundKind kind, std::span<const Rectangle> parts);

  private:
    // A triangle with corners on the grid, whose heights are those of the world.
    struct Seam {
        std::array<glm::ivec2, 3> on_grid;
        int corners;                // that are on the grid
        glm::vec3 lowest, highest;  // around the others, m; if there are none, lowest is higher
        std::size_t patch;
    };
    void find_seams(float cell);
    void find_parts(const WhatChanged& changed, const OnScreen& screen);

    OfGroundKind<ProgramName> programs_;
    std::uint64_t known_ = 0;  // fingerprint
    glm::vec4 known_sun_{0};
    SurroundingsMesh mesh_;
    std::vector<float> sunlit_;
    VertexArray vertex_array_;
    Buffer vertices_, sunlit_buffer_, indices_;
    Texture heights_, cover_;
    // Of one frame; kept so that a frame allocates nothing.
    std::vector<const SurroundingsPatch*> visible_;
    std::vector<Rectangle> seen_;  // of each of these
    std::vector<Seam> seams_;
    std::vector<glm::vec3> lowest_, highest_;  // of each patch, with the grid's heights now
    std::vector<GLsizei> counts_;
    std::vector<const void*> firsts_;
};

}  // namespace render
