#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/textures/tile.h"

namespace render {

// Heights whose histogram was made Gaussian, so that blended copies can keep it (Heitz and Neyret 2018,
// High-Performance By-Example Noise using a Histogram-Preserving Blending Operator, section 3).
struct Gaussian {
    std::vector<std::uint8_t> bytes;  // one per texel: 0 to 255 is 0 to 1, mean 0.5, deviation 1/6
    std::array<float, 256> raw{};     // the height in whose place a byte stands
};

// Each height is replaced by the value that a Gaussian has at the same rank; equal heights stay equal. What
// lies beyond 0 or 1, three deviations off, is cut off: 0.27 % of all.
Gaussian gaussianise(const Tile& raw);

// Share of a normal distribution (mean 0, deviation 1) below x, −4 ≤ x ≤ 4; to 1e-10, from its power series
// alone.
double normal_share_below(double x);

}  // namespace render
