#include <array>

#include "render/base/noise.h"
#include "render/textures/surface.h"

namespace render {
namespace {

// Deep sea, shallows, surf, sand, red earth. It is pale in the middle, so that the most common height forms
// lines that an eye can follow.
constexpr std::array kSea{
    ColourStop{0.10f, {0.055f, 0.090f, 0.200f}}, ColourStop{0.32f, {0.070f, 0.255f, 0.400f}},
    ColourStop{0.46f, {0.130f, 0.470f, 0.530f}}, ColourStop{0.54f, {0.560f, 0.740f, 0.680f}},
    ColourStop{0.60f, {0.950f, 0.900f, 0.740f}}, ColourStop{0.70f, {0.880f, 0.610f, 0.330f}},
    ColourStop{0.90f, {0.560f, 0.210f, 0.160f}}};

constexpr int kOctaves = 5;

}  // namespace

Surface make_perlin() {
    Tile tile = make_tile([](float u, float v) {
        float sum = 0, weight = 1;
        for (int octave = 0, period = 10; octave < kOctaves; ++octave, period *= 2, weight *= 0.5f)
            sum += weight *
                   gradient_noise(u * period, v * period, period, 500u + static_cast<std::uint32_t>(octave));
        return sum;
    });
    stretch(tile);
    return {std::move(tile), {}, {kSea.begin(), kSea.end()}};
}

}  // namespace render
