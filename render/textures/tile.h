#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>

#include "render/pictures/picture.h"

// A square of heights that repeats beyond its edges, and the images made from it.
namespace render {

inline constexpr int kTextureSize = 512;  // texels along an edge

// kTextureSize² heights, row-major, top row first.
struct Tile {
    std::vector<float> heights = std::vector<float>(kTextureSize * kTextureSize);

    // Texel at x, y ≥ −kTextureSize. The tile repeats on every side.
    float& at(int x, int y) { return heights[index(x, y)]; }
    float at(int x, int y) const { return heights[index(x, y)]; }

    static std::size_t index(int x, int y) {
        const auto wrap = [](int v) { return static_cast<std::size_t>((v + kTextureSize) % kTextureSize); };
        return wrap(y) * kTextureSize + wrap(x);
    }
};

// `height` is a function of u and v, which run from 0 to 1 over the tile, rightward and down.
Tile make_tile(const std::function<float(float u, float v)>& height);

// Removes features broader than `width` texels, so that no hill or hollow makes a part of the tile
// recognisable and small pieces show on low ground as on high.
void flatten(Tile& tile, int width);

// Scales the heights to 0 … 1.
void stretch(Tile& tile);

// Converts 0 … 1 to 8 bits; values outside are clamped.
std::uint8_t to_byte(float share);

// One channel: 0 to 1 as 0 to 255.
Picture grey_picture(const Tile& tile);

// One colour per pixel, each channel sRGB, 0 to 1.
Picture colour_picture(const std::vector<glm::vec3>& colours, int width);

// Tangent-space normals: red is x, rightward; green is y, toward the row above; blue is z, out of the image;
// (128, 128, 255) is level. Slopes are central differences of the heights times `relief`, which is a height
// of 1 as a share of the tile's edge.
Picture normal_picture(const Tile& tile, float relief);

}  // namespace render
