#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "render/frame/frame_input.h"
#include "render/gl/gl_handle.h"

namespace render {

// Water in the soil, as its overlay shows it and as wet ground without one: the field of things, 0 in a world without
// them.
class DrawnWater {
  public:
    // Returns the vertices where it differs from what was sent last, valid until the next call; nothing while it is not
    // shown. Allocates nothing while the grid stays.
    std::span<const glm::ivec2> send(const FrameInput& input);
    bool is_wet() const { return wet_ > 0; }  // what was sent last, anywhere
    // To SLOT_WATER, after a call of send() in which it was shown.
    void bind() const;

  private:
    sim::Grid grid_;
    sim::Field<float> sent_;
    std::vector<glm::ivec2> changed_;
    std::int64_t wet_ = 0;  // vertices
    Texture texture_;
};

}  // namespace render
