#pragma once

#include <cstdint>
#include <vector>

namespace render {

inline constexpr int kDetailSize = 512;  // texels along an edge of a layer

// Small-scale relief that tiles: kDetailSize² texels × 4 bytes × the layers of slots.glsl (soft, rock,
// clumps). A texel holds slope along x, slope along y (0.5 is level), height, and a second, broader height.
// It uses only integers and square roots, so it is the same on every machine.
std::vector<std::uint8_t> make_detail();

}  // namespace render
