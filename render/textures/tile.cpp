#include "render/textures/tile.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace render {
namespace {

// Maps −1 … 1 to a byte; 128 is 0.
std::uint8_t signed_to_byte(float value) {
    return static_cast<std::uint8_t>(std::lround(128 + 127 * value));
}

// Moving average over 2·reach + 1 texels along one axis.
Tile blurred(const Tile& tile, int reach, int step_x, int step_y) {
    Tile means;
    for (int y = 0; y < kTextureSize; ++y) {
        for (int x = 0; x < kTextureSize; ++x) {
            float sum = 0;
            for (int i = -reach; i <= reach; ++i) sum += tile.at(x + i * step_x, y + i * step_y);
            means.at(x, y) = sum / static_cast<float>(2 * reach + 1);
        }
    }
    return means;
}

}  // namespace

Tile make_tile(const std::function<float(float u, float v)>& height) {
    Tile tile;
    for (int y = 0; y < kTextureSize; ++y) {
        for (int x = 0; x < kTextureSize; ++x)
            tile.at(x, y) =
                height(static_cast<float>(x) / kTextureSize, static_cast<float>(y) / kTextureSize);
    }
    return tile;
}

void flatten(Tile& tile, int width) {
    Tile broad = tile;
    for (int pass = 0; pass < 2; ++pass) broad = blurred(blurred(broad, width / 2, 1, 0), width / 2, 0, 1);
    for (std::size_t i = 0; i < tile.heights.size(); ++i) tile.heights[i] -= broad.heights[i];
}

void stretch(Tile& tile) {
    const auto [low, high] = std::minmax_element(tile.heights.begin(), tile.heights.end());
    const float lowest = *low, span = *high - *low;
    for (float& height : tile.heights) height = (height - lowest) / span;
}

std::uint8_t to_byte(float share) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.f, 1.f)));
}

Picture grey_picture(const Tile& tile) {
    Picture picture{kTextureSize, kTextureSize, {}, 1};
    for (const float height : tile.heights) picture.pixels.push_back(to_byte(height));
    return picture;
}

Picture colour_picture(const std::vector<glm::vec3>& colours, int width) {
    Picture picture{width, static_cast<int>(colours.size()) / width, {}};
    for (const glm::vec3& colour : colours) {
        for (int c = 0; c < 3; ++c) picture.pixels.push_back(to_byte(colour[c]));
    }
    return picture;
}

Picture normal_picture(const Tile& tile, float relief) {
    Picture picture{kTextureSize, kTextureSize, {}};
    const float per_step = 0.5f * relief * kTextureSize;  // slope where heights two texels apart differ by 1
    for (int y = 0; y < kTextureSize; ++y) {
        for (int x = 0; x < kTextureSize; ++x) {
            const float rightward = per_step * (tile.at(x + 1, y) - tile.at(x - 1, y));
            const float upward = per_step * (tile.at(x, y - 1) - tile.at(x, y + 1));
            const glm::vec3 normal = glm::normalize(glm::vec3(-rightward, -upward, 1));
            for (int c = 0; c < 3; ++c) picture.pixels.push_back(signed_to_byte(normal[c]));
        }
    }
    return picture;
}

}  // namespace render
