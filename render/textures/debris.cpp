#include <array>
#include <span>

#include "render/base/noise.h"
#include "render/textures/lumps.h"
#include "render/textures/surface.h"

namespace render {
namespace {

struct Scale {
    int period;
    float share, smallest, largest;  // as in Lumps
};

// From small to large, so that a large lump has clean faces and small ones fill the gaps; at last a few
// crumbs lie on top. The largest size has 9 or 10 to an edge, enough that no lump is recognisable when the
// tile repeats.
constexpr std::array kSnowScales{Scale{86, 0.80f, 0.30f, 0.60f}, Scale{54, 0.80f, 0.30f, 0.60f},
                                 Scale{34, 0.75f, 0.30f, 0.60f}, Scale{22, 0.80f, 0.35f, 0.62f},
                                 Scale{14, 0.80f, 0.35f, 0.60f}, Scale{9, 0.90f, 0.28f, 0.55f},
                                 Scale{60, 0.12f, 0.20f, 0.50f}};
constexpr std::array kSoilScales{Scale{100, 0.80f, 0.30f, 0.60f}, Scale{66, 0.80f, 0.30f, 0.60f},
                                 Scale{42, 0.75f, 0.30f, 0.60f},  Scale{27, 0.75f, 0.35f, 0.60f},
                                 Scale{17, 0.75f, 0.35f, 0.60f},  Scale{10, 0.90f, 0.28f, 0.56f},
                                 Scale{80, 0.20f, 0.20f, 0.60f}};

constexpr std::array kSnowColours{
    ColourStop{0.06f, {0.600f, 0.672f, 0.780f}}, ColourStop{0.20f, {0.795f, 0.842f, 0.905f}},
    ColourStop{0.34f, {0.895f, 0.922f, 0.953f}}, ColourStop{0.55f, {0.953f, 0.964f, 0.977f}},
    ColourStop{0.90f, {0.990f, 0.990f, 0.987f}}};
constexpr std::array kSoilColours{
    ColourStop{0.08f, {0.195f, 0.132f, 0.085f}}, ColourStop{0.24f, {0.390f, 0.281f, 0.188f}},
    ColourStop{0.40f, {0.545f, 0.412f, 0.290f}}, ColourStop{0.60f, {0.640f, 0.503f, 0.365f}},
    ColourStop{0.90f, {0.695f, 0.577f, 0.445f}}};

// Lumps of one material at all scales.
Tile heap(Lumps lumps, std::span<const Scale> scales) {
    Tile tile;
    for (const Scale& scale : scales) {
        lumps.period = scale.period;
        lumps.share = scale.share;
        lumps.smallest = scale.smallest;
        lumps.largest = scale.largest;
        strew(tile, lumps);
        lumps.seed += kSeedsPerScale;
    }
    return tile;
}

// Adds noise up to `height`, tile edges.
void roughen(Tile& tile, float height, int period, std::uint32_t seed) {
    const Tile rough =
        make_tile([&](float u, float v) { return height * fractal_noise(u, v, period, seed, 4); });
    for (std::size_t i = 0; i < tile.heights.size(); ++i) tile.heights[i] += rough.heights[i];
}

}  // namespace

Surface make_snow() {
    constexpr Lumps kBlocks{
        .height = 0.6f, .wall = 2.3f, .tilt = 0.4f, .rounding = 0.25f, .buried = 0.35f, .seed = 630};
    Tile tile = heap(kBlocks, kSnowScales);
    roughen(tile, 0.006f, 30, 590);
    flatten(tile, 72);
    stretch(tile);
    return {std::move(tile), {}, {kSnowColours.begin(), kSnowColours.end()}};
}

Surface make_soil() {
    constexpr Lumps kClods{
        .height = 0.6f, .wall = 1.7f, .tilt = 0.5f, .rounding = 0.32f, .buried = 0.4f, .seed = 1230};
    Tile tile = heap(kClods, kSoilScales);
    roughen(tile, 0.022f, 22, 880);
    flatten(tile, 64);
    stretch(tile);
    return {std::move(tile), {}, {kSoilColours.begin(), kSoilColours.end()}};
}

}  // namespace render
