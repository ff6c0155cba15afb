#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "render/base/rectangle.h"

namespace render {

// The parts of a frame in which powder or its shadow may be seen, so that the rest costs nothing.
class PowderTiles {
  public:
    // Begins with none. `width` and `height` in samples. Allocates nothing while they are those of the last
    // call.
    void begin(int width, int height);
    // Adds an ellipse with this middle and these half axes, −1 to 1, and the coarse pixels beside it.
    void add(glm::vec2 middle, glm::vec2 half);
    // Joins the tiles along each row. Each sample of the frame is in one of them at most.
    std::span<const Rectangle> collect();

  private:
    int width_ = 0, height_ = 0;       // samples
    int columns_ = 0, rows_ = 0;       // tiles
    std::vector<std::uint8_t> tiles_;  // 1: powder
    std::vector<Rectangle> rectangles_;
};

}  // namespace render
