#pragma once

#include <cstdint>

#include "render/frame/frame_input.h"
#include "render/gl/gl_handle.h"
#include "sim/core/grid.h"

namespace render {

// Has FrameInput::probability as a texture, one texel per vertex, while surfaces are computed.
class DrawnProbability {
  public:
    // At SLOT_PROBABILITY; uploads it if it is another one. Without one it is 0 everywhere.
    void bind(const FrameInput& input);

  private:
    sim::Grid grid_;
    std::int32_t sent_ = -1;  // Marks::probability
    Texture texture_;
};

}  // namespace render
