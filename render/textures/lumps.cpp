#include "render/textures/lumps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "render/base/noise.h"
#include "render/textures/smooth.h"

namespace render {
namespace {

constexpr int kSides = 7;
constexpr float kWidest = 1.3f;  // extent of a lump at its foot, radii
constexpr float kReach = 2;      // radius of the area that a lump affects, radii
constexpr float kOverhang = 3;   // factor on the steepness below its foot

struct Plane {
    glm::vec2 downhill;  // its slope
    float foot;          // height over the middle
};

// Lengths in radii.
struct Lump {
    glm::vec2 middle{};  // tile edges
    float radius = 0;    // tile edges
    std::array<Plane, kSides + 1> planes{};
};

Lump make_lump(const Lumps& lumps, int cx, int cy) {
    const auto random = [&](int which, float low, float high) {
        return std::lerp(low, high,
                         hash(cx, cy, lumps.period, lumps.seed + static_cast<std::uint32_t>(which)));
    };
    const float cells = static_cast<float>(lumps.period);
    Lump lump;
    lump.middle = glm::vec2(cx + random(1, 0.1f, 0.9f), cy + random(2, 0.1f, 0.9f)) / cells;
    lump.radius = random(3, lumps.smallest, lumps.largest) / cells;
    lump.planes[0] = {random(4, 0, lumps.tilt) * direction_of(random(5, 0, 1)), lumps.height};
    for (int side = 1; side <= kSides; ++side) {
        const float turn = (side - 1 + random(5 + side, 0, 0.9f)) / kSides;
        const float wall = lumps.wall * random(12 + side, 0.6f, 1.4f);
        const float distance = random(19 + side, 0.6f, 1);
        lump.planes[static_cast<std::size_t>(side)] = {wall * direction_of(turn), wall * distance};
    }
    return lump;
}

// Height over the lump's foot at an offset from its middle, both in radii.
float height_at(const Lump& lump, const Lumps& lumps, glm::vec2 place) {
    float height = lumps.wall * (kWidest - glm::length(place));
    for (const Plane& plane : lump.planes)
        height = smooth_min(height, plane.foot - glm::dot(plane.downhill, place), lumps.rounding);
    height -= lumps.buried * lumps.height;
    // Where the ground drops away under a lump, as at the rim of a larger one, the lump ends at its outline.
    return height < 0 ? kOverhang * height : height;
}

void lay(Tile& tile, const Lump& lump, const Lumps& lumps, float foot) {
    const auto first = [&](float middle) {
        return static_cast<int>(std::floor((middle - kReach * lump.radius) * kTextureSize));
    };
    const int span = static_cast<int>(2 * kReach * lump.radius * kTextureSize) + 2;
    for (int y = first(lump.middle.y); y <= first(lump.middle.y) + span; ++y) {
        for (int x = first(lump.middle.x); x <= first(lump.middle.x) + span; ++x) {
            const glm::vec2 place =
                (glm::vec2(x, y) / static_cast<float>(kTextureSize) - lump.middle) / lump.radius;
            float& height = tile.at(x, y);
            height = std::max(height, foot + lump.radius * height_at(lump, lumps, place));
        }
    }
}

}  // namespace

void strew(Tile& tile, const Lumps& lumps) {
    const Tile before = tile;
    for (int cy = 0; cy < lumps.period; ++cy) {
        for (int cx = 0; cx < lumps.period; ++cx) {
            if (hash(cx, cy, lumps.period, lumps.seed) >= lumps.share) continue;
            const Lump lump = make_lump(lumps, cx, cy);
            const auto texel = [](float place) { return static_cast<int>(place * kTextureSize); };
            lay(tile, lump, lumps, before.at(texel(lump.middle.x), texel(lump.middle.y)));
        }
    }
}

}  // namespace render
