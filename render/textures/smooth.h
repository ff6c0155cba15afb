#pragma once

#include <algorithm>
#include <cmath>

namespace render {

// The smaller of two values, reduced by up to `width` / 4 if they differ by less than `width` > 0.
inline float smooth_min(float a, float b, float width) {
    const float near = std::max(width - std::abs(a - b), 0.f) / width;
    return std::min(a, b) - 0.25f * width * near * near;
}

}  // namespace render
