#pragma once

namespace render {

// How a photo differs from what the eye sees.
struct Lens {
    double exposure = 1;  // factor on all light, > 0
    bool operator==(const Lens&) const = default;
};

}  // namespace render
