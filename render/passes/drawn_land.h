#pragma once

#include <cstdint>
#include <optional>

#include "render/frame/frame_input.h"
#include "render/gl/gl_handle.h"

namespace render {

// What plants and water find on the ground, for the shaders of a frame whose look has a date.
class DrawnLand {
  public:
    // SLOT_LAND: the frame's land, uploaded when it is new; without a date or a land, ground that is dry and without brooks.
    void bind(const FrameInput& input);

  private:
    std::optional<std::uint64_t> known_;  // fingerprint of the land; 0: none
    Texture texture_;
};

}  // namespace render
