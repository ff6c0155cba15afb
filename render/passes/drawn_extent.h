#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "render/gl/gl_handle.h"
#include "sim/core/grid.h"

namespace render {

// Uploads FrameInput::extent as a texture, one texel per vertex, if it changed since the last upload.
class DrawnExtent {
  public:
    // Returns the vertices where it differs from the last one that was not empty; valid until the next call.
    std::span<const glm::ivec2> send(std::span<const std::uint8_t> extent, const sim::Grid& grid);
    void bind() const;  // at SLOT_EXTENT

  private:
    int nx_ = 0, ny_ = 0;
    Texture texture_;
    std::vector<std::uint8_t> sent_;
    std::vector<glm::ivec2> changed_;
};

}  // namespace render
