#pragma once

#include <span>

namespace render {

// The greatest depth (m) and speed (m/s) of the rolling layer until now, one value per vertex, row 0 the south. Empty:
// nothing has moved.
struct FlowSoFar {
    std::span<const float> depth, speed;
};

}  // namespace render
