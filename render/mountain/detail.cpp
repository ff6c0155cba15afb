#include "render/mountain/detail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <future>

#include "assets/shaders/slots.glsl"
#include "render/base/noise.h"

namespace render {
namespace {

constexpr int kTexels = kDetailSize * kDetailSize;

// Sharp crests like fractured stone. Each octave is stronger where the previous one is high.
float rock(float u, float v) {
    float sum = 0, weight = 0.55f, carry = 1;
    const float bend = 0.06f * fractal_noise(u, v, 4, 91), bend_v = 0.06f * fractal_noise(u, v, 4, 92);
    for (int octave = 0, period = 5; octave < 6; ++octave, period *= 2, weight *= 0.55f) {
        const float n = value_noise((u + bend) * period, (v + bend_v) * period, period,
                                    40 + static_cast<std::uint32_t>(octave));
        const float crest = 1 - std::abs(2 * n - 1);
        sum += weight * crest * crest * carry;
        carry = std::clamp(1.4f * crest, 0.3f, 1.f);
    }
    return sum;
}

// Domes scattered over a lattice. The highest dome at a point counts.
float domes(float u, float v, int period, std::uint32_t seed) {
    const float x = u * period, y = v * period;
    const int ix = static_cast<int>(x), iy = static_cast<int>(y);
    float highest = 0;
    for (int cy = iy - 1; cy <= iy + 1; ++cy) {
        for (int cx = ix - 1; cx <= ix + 1; ++cx) {
            const float dx = x - (cx + hash(cx, cy, period, seed)),
                        dy = y - (cy + hash(cx, cy, period, seed + 1));
            const float radius = 0.45f + 0.5f * hash(cx, cy, period, seed + 2);
            const float rest = radius * radius - dx * dx - dy * dy;
            if (rest > 0) highest = std::max(highest, std::sqrt(rest));
        }
    }
    return highest;
}

float clumps(float u, float v) {
    return 0.55f * domes(u, v, 14, 7) + 0.32f * domes(u, v, 31, 17) + 0.18f * domes(u, v, 67, 27) +
           0.2f * fractal_noise(u, v, 8, 37);
}

// Index of a texel. The tile repeats beyond its edges.
std::size_t index(int x, int y) {
    return static_cast<std::size_t>(y % kDetailSize) * kDetailSize +
           static_cast<std::size_t>(x % kDetailSize);
}

// Heights of one layer, scaled to 0 to 1.
std::vector<float> heights(const std::function<float(float, float)>& height) {
    std::vector<float> h(kTexels);
    for (int y = 0; y < kDetailSize; ++y) {
        for (int x = 0; x < kDetailSize; ++x)
            h[index(x, y)] = height(static_cast<float>(x) / kDetailSize, static_cast<float>(y) / kDetailSize);
    }
    const auto [low, high] = std::minmax_element(h.begin(), h.end());
    const float lowest = *low, span = *high - *low;
    for (float& value : h) value = (value - lowest) / span;
    return h;
}

std::uint8_t to_byte(float share) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.f, 1.f)));
}

// `steepness` scales the layer's slopes, per texel, to about −1 to 1.
void append_layer(std::vector<std::uint8_t>& texels, const std::vector<float>& h,
                  const std::vector<float>& broad, float steepness) {
    const auto at = [&h](int x, int y) { return h[index(x, y)]; };
    for (int y = 0; y < kDetailSize; ++y) {
        for (int x = 0; x < kDetailSize; ++x) {
            const float slope_x = at(x + 1, y) - at(x + kDetailSize - 1, y);
            const float slope_y = at(x, y + 1) - at(x, y + kDetailSize - 1);
            const std::array<std::uint8_t, 4> texel{to_byte(0.5f + 0.5f * steepness * slope_x),
                                                    to_byte(0.5f + 0.5f * steepness * slope_y),
                                                    to_byte(at(x, y)), to_byte(broad[index(x, y)])};
            texels.insert(texels.end(), texel.begin(), texel.end());
        }
    }
}

}  // namespace

std::vector<std::uint8_t> make_detail() {
    static_assert(DETAIL_SOFT == 0 && DETAIL_ROCK == 1 && DETAIL_CLUMPS == 2 && DETAIL_LAYERS == 3);
    // Each on a thread of its own: a start waits for them.
    auto rocks = std::async(std::launch::async, heights, rock);
    auto clumped = std::async(std::launch::async, heights, clumps);
    auto soft =
        std::async(std::launch::async, heights, [](float u, float v) { return fractal_noise(u, v, 6, 1); });
    const std::vector<float> broad = heights([](float u, float v) { return fractal_noise(u, v, 3, 71); });
    std::vector<std::uint8_t> texels;
    texels.reserve(4ull * kTexels * DETAIL_LAYERS);
    append_layer(texels, soft.get(), broad, 12.f);
    append_layer(texels, rocks.get(), broad, 9.f);
    append_layer(texels, clumped.get(), broad, 9.f);
    return texels;
}

}  // namespace render
