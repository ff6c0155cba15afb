#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "render/frame/frame_input.h"
#include "render/mountain/height_range.h"
#include "render/view/frame_block.h"

namespace render {

// `heights`: of the bedrock. `samples`: along the edge of a pixel. `flow_tint`: the factor for the colours of
// the advected texture. None: no texture is shown.
FrameBlock make_frame_block(const FrameInput& input, HeightRange heights, int samples,
                            const std::optional<glm::vec3>& flow_tint);

// The block by which the ground is shaded for every second sample along x and y of a frame of this size, without marks
// that have lines: passes/coarse_ground.h.
FrameBlock coarse_frame_block(const FrameBlock& frame, int samples_across, int samples_up);

}  // namespace render
