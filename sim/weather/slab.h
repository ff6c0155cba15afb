#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "sim/core/chance.h"
#include "sim/simd/exponential.h"
#include "sim/world/params.h"
#include "sim/world/state.h"
#include "sim/world/weather.h"

// The slab above the weak interface of a vertex: how stable it is, and how an interface is buried.

namespace sim::weather {

inline constexpr float kStable = 99;            // index of what cannot release
inline constexpr float kLeastSlab = 0.15f;      // m of d that is a slab
inline constexpr float kLeastTangent = 0.3f;    // of the surface where one could matter
inline constexpr float kNetStrength = 3000;     // Pa, of what forest or nets hold in full
inline constexpr float kPersistentBelow = 600;  // Pa; a weaker surface is hoar or facets

// The index of stability S: strength of the interface over the shear stress of the slab on it. `steep`: squared tangent of
// the surface.
inline float stability_of(const Weather& w, const Things& things, float density, float d, float steep, int x,
                          int y) {
    const float slab = d - w.base(x, y);
    if (slab < kLeastSlab || steep < kLeastTangent * kLeastTangent) return kStable;
    const float shear = density * static_cast<float>(kGravity) * slab * std::sqrt(steep) / (1 + steep);
    // Wet snow: Yamanoi and Endo (2002); p is the share of water in per cent.
    const float percent = std::min(0.15f * w.water(x, y) / slab, 8.f);
    const float strength = std::abs(w.strength(x, y)) * exp(-0.235f * percent);
    return std::min((strength + kNetStrength * held_share(things, x, y, d)) / shear, kStable);
}

// From 0 to 1, another for each place and key.
inline float chance_at(std::uint32_t x, std::uint32_t y, std::uint32_t key) {
    return share_of(mixed(std::uint64_t{key} << 32 | y << 16 | x));
}

// How strong an interface is, of what it would be everywhere: 0.7 to 1.3, smooth over 60 m and rough from vertex to vertex.
inline float variation(const Grid& grid, int x, int y, std::uint32_t key) {
    constexpr float kSmoothOver = 60;  // m
    const float cells = std::max(kSmoothOver / grid.dx, 1.f);
    const float u = static_cast<float>(x) / cells, v = static_cast<float>(y) / cells;
    const auto column = static_cast<std::uint32_t>(u), row = static_cast<std::uint32_t>(v);
    const auto eased = [](float t) { return t * t * (3 - 2 * t); };
    const float right = eased(u - static_cast<float>(column)), up = eased(v - static_cast<float>(row));
    const auto along = [&](std::uint32_t j) {
        const float from = chance_at(column, j, key), to = chance_at(column + 1, j, key);
        return from + (to - from) * right;
    };
    const float low = along(row), wide = low + (along(row + 1) - low) * up;
    const float fine = chance_at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), key + 1);
    return 0.7f + 0.6f * (0.8f * wide + 0.2f * fine);
}

// Snow comes to lie on a surface: where the old interface does not matter any more, this is the new one.
struct Burial {
    const Things& things;
    const Grid& grid;
    float density;
    std::uint32_t key;

    Burial(const State& s, int event)
        : things(*s.things),
          grid(s.grid),
          density(s.params.density),
          key(static_cast<std::uint32_t>(event) * 7919u +
              static_cast<std::uint32_t>(s.weather->calendar.seed)) {}

    void operator()(Weather& w, float d, float steep, int x, int y) const {
        constexpr float kThinSlab = 0.02f, kStableEnough = 2;  // m; index
        float& surface = w.surface(x, y);
        const bool buries =
            surface >= 0 && (d - w.base(x, y) < kThinSlab ||
                             stability_of(w, things, density, d, steep, x, y) > kStableEnough);
        if (buries) {
            const float strength = surface * variation(grid, x, y, key);
            w.base(x, y) = d;
            w.strength(x, y) = surface < kPersistentBelow ? -strength : strength;
            w.water(x, y) = 0;
        }
        surface = -1;
    }
};

}  // namespace sim::weather
