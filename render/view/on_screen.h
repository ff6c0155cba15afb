#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "render/base/rectangle.h"

namespace render {

// Where things appear in a frame.
class OnScreen {
  public:
    OnScreen() = default;
    // `width` and `height` of the frame in samples.
    OnScreen(const glm::mat4& clip_from_world, int width, int height)
        : clip_from_world_(clip_from_world), width_(width), height_(height) {}

    // The samples that anything in a box may cover, and one more on each side for rounding. Empty if the box is beside
    // the frame or behind the eye; all of the frame if the eye is in it or beside it.
    Rectangle box(const glm::vec3& lowest, const glm::vec3& highest) const;
    // The same for a ball.
    Rectangle ball(const glm::vec3& middle, float radius) const {
        return box(middle - radius, middle + radius);
    }
    Rectangle all() const { return {0, 0, width_, height_}; }

  private:
    glm::mat4 clip_from_world_{1};
    int width_ = 0, height_ = 0;
};

}  // namespace render
