#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "render/base/noise.h"
#include "render/textures/lumps.h"
#include "render/textures/smooth.h"
#include "render/textures/surface.h"

// Stones are placed from large to small, and each is kept only if it touches no other. A stone occupies its
// cell of the power diagram of the stones' circles, shrunk by half a gap and with rounded corners:
//
//     edge(p) = smooth min over others j of (d_j(p) − d_i(p)) / (2 |m_j − m_i|),   d = |p − m|² − r²
//
// This is the distance to the boundary between stone i and stone j. Lengths are in tile edges.
namespace render {
namespace {

struct Stone {
    glm::vec2 middle{};
    float radius = 0;
    std::uint32_t name = 0;  // seeds its own variation
};

// The position of a texel on its stone.
struct Place {
    const Stone* stone = nullptr;
    float edge = 0;  // to the stone's edge, positive inside
};

struct Size {
    float radius;
    int throws;
};

constexpr std::array kSizes{Size{0.050f, 60},   Size{0.043f, 160},  Size{0.036f, 400},
                            Size{0.028f, 1500}, Size{0.020f, 3000}, Size{0.013f, 4000}};
constexpr float kOverlap = 0.90f;  // least distance between stones, as a share of the sum of their radii
constexpr float kHalfGap = 0.0026f;
constexpr float kCorner = 0.014f;        // rounding of corners
constexpr float kNeighbourhood = 0.16f;  // distance beyond which a stone is no neighbour

// The shortest vector between two points on the repeating tile.
glm::vec2 way(glm::vec2 from, glm::vec2 to) {
    const glm::vec2 straight = to - from;
    return straight - glm::floor(straight + 0.5f);
}

float random(std::uint32_t name, int which) {
    return hash(static_cast<int>(name), which, 1 << 20, 301);
}

std::vector<Stone> throw_stones() {
    std::vector<Stone> stones;
    std::uint32_t name = 0;
    for (const Size& size : kSizes) {
        for (int i = 0; i < size.throws; ++i, ++name) {
            const Stone stone{
                {random(name, 0), random(name, 1)}, size.radius * (0.9f + 0.2f * random(name, 2)), name};
            const bool touches = std::any_of(stones.begin(), stones.end(), [&](const Stone& other) {
                return glm::length(way(stone.middle, other.middle)) <
                       kOverlap * (stone.radius + other.radius);
            });
            if (!touches) stones.push_back(stone);
        }
    }
    return stones;
}

float power(const Stone& stone, glm::vec2 place) {
    const glm::vec2 off = way(stone.middle, place);
    return glm::dot(off, off) - stone.radius * stone.radius;
}

Place place_on(const std::vector<Stone>& stones, glm::vec2 place) {
    const auto nearer = [&](const Stone& a, const Stone& b) { return power(a, place) < power(b, place); };
    const Stone& mine = *std::min_element(stones.begin(), stones.end(), nearer);
    const float own = power(mine, place);
    // Without near neighbours, a stone ends shortly beyond its circle.
    float edge = 1.30f * mine.radius - glm::length(way(mine.middle, place));
    for (const Stone& other : stones) {
        const float apart = glm::length(way(mine.middle, other.middle));
        if (&other == &mine || apart > kNeighbourhood) continue;
        edge = smooth_min(edge, (power(other, place) - own) / (2 * apart), kCorner);
    }
    return {&mine, edge - kHalfGap};
}

// 1 at the middle, vertical at the edge, 0 outside.
float dome(const Place& place) {
    const float inward = std::clamp(place.edge / (0.75f * place.stone->radius), 0.f, 1.f);
    return std::sqrt(inward * (2 - inward));
}

// Most stones are grey, a few are sandy, slate or rusty. None stands out so far that it would be recognised
// where the tile repeats.
glm::vec3 colour_of(const Stone& stone) {
    constexpr std::array<glm::vec3, 8> kKinds{glm::vec3{0.575f, 0.555f, 0.520f}, {0.520f, 0.530f, 0.540f},
                                              {0.610f, 0.600f, 0.580f},          {0.470f, 0.480f, 0.500f},
                                              {0.560f, 0.525f, 0.470f},          {0.540f, 0.540f, 0.530f},
                                              {0.500f, 0.465f, 0.430f},          {0.440f, 0.450f, 0.465f}};
    const auto kind = static_cast<std::size_t>(random(stone.name, 3) * kKinds.size());
    return kKinds[kind] * (0.97f + 0.18f * random(stone.name, 4));
}

// Mottled, speckled, and dirty toward the edge. u and v run from 0 to 1 over the tile.
glm::vec3 stone_colour(const Place& place, float u, float v) {
    const std::uint32_t seed = 400 + place.stone->name % 16;
    const float mottle = fractal_noise(u, v, 14, seed, 4) - 0.5f;
    const float speck = value_noise(u * 170, v * 170, 170, seed + 50);
    const float grain = speck > 0.78f ? 0.5f * (speck - 0.78f) : speck < 0.2f ? 0.6f * (speck - 0.2f) : 0.f;
    const float dirt = 1 - dome(place);
    return colour_of(*place.stone) * (1 + 0.35f * mottle + grain) *
           (glm::vec3(1) - dirt * glm::vec3(0.30f, 0.34f, 0.40f));
}

// Pale on its tops, with earth between. `height` is as in make_gravel.
glm::vec3 gravel_colour(float height, float u, float v) {
    const float tone = 0.7f + 0.6f * value_noise(u * 60, v * 60, 60, 471);
    return glm::vec3(0.200f, 0.180f, 0.158f) +
           2.0f * std::clamp(height - 0.04f, 0.f, 0.15f) * tone * glm::vec3(1.02f, 0.98f, 0.90f);
}

// Gravel in the gaps. Heights are relative to those of stones, whose tops are near 1.
Tile make_gravel() {
    Tile gravel = make_tile([](float u, float v) { return 0.064f * fractal_noise(u, v, 24, 440, 3); });
    Tile pebbles;
    strew(pebbles, {.period = 44,
                    .smallest = 0.35f,
                    .largest = 0.6f,
                    .height = 0.8f,
                    .wall = 2,
                    .rounding = 0.4f,
                    .seed = 450});
    for (std::size_t i = 0; i < gravel.heights.size(); ++i) gravel.heights[i] += 16 * pebbles.heights[i];
    return gravel;
}

}  // namespace

Surface make_stones() {
    const std::vector<Stone> stones = throw_stones();
    Surface surface{make_gravel(), {}, {}};
    for (int y = 0; y < kTextureSize; ++y) {
        for (int x = 0; x < kTextureSize; ++x) {
            const float u = static_cast<float>(x) / kTextureSize, v = static_cast<float>(y) / kTextureSize;
            const glm::vec2 bend(fractal_noise(u, v, 9, 420, 4) - 0.5f,
                                 fractal_noise(u, v, 9, 430, 4) - 0.5f);
            const Place place = place_on(stones, glm::vec2(u, v) + 0.045f * bend);
            const float rough = 0.10f * (fractal_noise(u, v, 20, 460, 4) - 0.5f);
            const float stone = dome(place) * (0.72f + 0.28f * random(place.stone->name, 5) + rough);
            float& height = surface.heights.at(x, y);
            surface.colours.push_back(stone > height ? stone_colour(place, u, v)
                                                     : gravel_colour(height, u, v));
            height = std::max(stone, height);
        }
    }
    stretch(surface.heights);
    return surface;
}

}  // namespace render
