#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "render/frame_block.h"
#include "render/gl_handle.h"
#include "render/surroundings.h"
#include "render/surroundings_mesh.h"

namespace render {

// Draws the mountains around the block.
class SurroundingsPass {
  public:
    static tl::expected<SurroundingsPass, std::string> create(const std::filesystem::path& shaders);

    // Computes and uploads what depends on the surroundings, and on the direction of the sun: a tenth of a second
    // and a few hundredths. Does nothing if both are known.
    void survey(const Surroundings& around, const FrameBlock& frame);
    void bind() const;  // SLOT_SURROUNDINGS: the rough heights; SLOT_FIRST_COVER
    // Draws colour and depth, where nothing nearer was drawn. Reads SLOT_RELIEF, SLOT_LAYERS, SLOT_MIXTURE,
    // SLOT_DETAIL, SLOT_FIRST_COVER.
    void draw(const FrameBlock& frame);

  private:
    // Variants, because shader code costs time even if its branch is not taken.
    ProgramName one_material_, two_materials_;
    std::uint64_t known_ = 0;  // fingerprint
    glm::vec4 known_sun_{0};
    SurroundingsMesh mesh_;
    std::vector<float> sunlit_;
    VertexArray vertex_array_;
    Buffer vertices_, sunlit_buffer_, indices_;
    Texture heights_, cover_;
    // Of one frame; kept so that a frame allocates nothing.
    std::vector<const SurroundingsPatch*> visible_;
    std::vector<GLsizei> counts_;
    std::vector<const void*> firsts_;
};

}  // namespace render
