#pragma once

namespace render {

// How a photo differs from what the eye sees. What is at a distance d is blurred by a radius of blur · |1 − focus_m / d|,
// kMostBlur at most.
struct Lens {
    static constexpr double kMostBlur = 0.025;  // of the image's height

    double exposure = 1;  // factor on all light, > 0
    double blur =
        0;  // radius by which what is infinitely far is blurred, in heights of the image; 0: all is sharp
    double focus_m = 1;  // distance along the view of what is sharp, > 0
    bool operator==(const Lens&) const = default;
};

}  // namespace render
