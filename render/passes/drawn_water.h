#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "render/frame/frame_input.h"
#include "render/gl/gl_handle.h"

namespace render {

// Water in the soil as an overlay shows it: the field of things, 0 in a world without them.
class DrawnWater {
  public:
    // Returns the vertices where it differs from what was sent last, valid until the next call; nothing while another
    // overlay is shown. Allocates nothing while the grid stays.
    std::span<const glm::ivec2> send(const FrameInput& input);
    // To SLOT_WATER. Needs a call of send() with this overlay.
    void bind() const;

  private:
    sim::Grid grid_;
    sim::Field<float> sent_;
    std::vector<glm::ivec2> changed_;
    Texture texture_;
};

}  // namespace render
