#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/textures/tile.h"

namespace render {

// Heights transformed to a Gaussian histogram, so that blends of copies can preserve it (Heitz and Neyret
// 2018, High-Performance By-Example Noise using a Histogram-Preserving Blending Operator, section 3).
struct Gaussian {
    std::vector<std::uint8_t> bytes;  // one per texel: 0 to 255 is 0 to 1, mean 0.5, deviation 1/6
    std::array<float, 256> raw{};     // the raw height that a byte represents
};

// Replaces each height by the Gaussian value of the same rank; equal heights stay equal. Values beyond 0 or
// 1, three deviations off, are clamped: 0.27 % of all.
Gaussian gaussianise(const Tile& raw);

// Share of a normal distribution (mean 0, deviation 1) below x, −4 ≤ x ≤ 4, accurate to 1e-10. It uses only
// the power series.
double normal_share_below(double x);

}  // namespace render
