#pragma once

#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

// Noise that tiles. It uses only integers, + − × ÷ and square roots, so it is bit-identical on every machine.
namespace render {

// Hashes a cell of a lattice that repeats after `period` cells to 0 … 1, excluding 1.
inline float hash(int x, int y, int period, std::uint32_t seed) {
    const auto wrap = [period](int v) {
        const int within = v % period;
        return static_cast<std::uint32_t>(within < 0 ? within + period : within);
    };
    std::uint32_t h = wrap(x) * 0x9E3779B1u ^ wrap(y) * 0x85EBCA77u ^ seed * 0xC2B2AE3Du;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return static_cast<float>((h ^ (h >> 15)) >> 8) / 16777216.f;
}

// Smooth step from 0 to 1; its first two derivatives are 0 at both ends.
inline float ease(float t) {
    return t * t * t * (t * (6 * t - 15) + 10);
}

// Value noise with smooth second derivatives, 0 to 1. x and y are in cells.
inline float value_noise(float x, float y, int period, std::uint32_t seed) {
    const float fx = std::floor(x), fy = std::floor(y);
    const int ix = static_cast<int>(fx), iy = static_cast<int>(fy);
    const float u = ease(x - fx), v = ease(y - fy);
    const float south = std::lerp(hash(ix, iy, period, seed), hash(ix + 1, iy, period, seed), u);
    const float north = std::lerp(hash(ix, iy + 1, period, seed), hash(ix + 1, iy + 1, period, seed), u);
    return std::lerp(south, north, v);
}

// Sums octaves of value noise, each half as strong and half as broad as the previous one; 0 to 1. The
// broadest has `first` cells to the tile. u and v run from 0 to 1 over the tile.
inline float fractal_noise(float u, float v, int first, std::uint32_t seed, int octaves = 6) {
    float sum = 0, weight = 0.5f;
    for (int octave = 0, period = first; octave < octaves; ++octave, period *= 2, weight *= 0.5f)
        sum +=
            weight * value_noise(u * period, v * period, period, seed + static_cast<std::uint32_t>(octave));
    return sum;
}

// A unit vector that turns once as `share` runs from 0 to 1, by the half-angle tangent. Its angular rate is
// 0.64 to 1.27 of a uniform turn.
inline glm::vec2 direction_of(float share) {
    const float side = share < 0.5f ? 1.f : -1.f;
    const float t = 4 * (share < 0.5f ? share : share - 0.5f) - 1;
    return side * glm::vec2(1 - t * t, 2 * t) / (1 + t * t);
}

// Gradient noise (Perlin 2002), −0.71 to 0.71 and 0 at the lattice's vertices. x and y are in cells.
inline float gradient_noise(float x, float y, int period, std::uint32_t seed) {
    const float fx = std::floor(x), fy = std::floor(y);
    const int ix = static_cast<int>(fx), iy = static_cast<int>(fy);
    const auto corner = [&](int i, int j) {
        return glm::dot(direction_of(hash(ix + i, iy + j, period, seed)), glm::vec2(x - fx - i, y - fy - j));
    };
    const float u = ease(x - fx), v = ease(y - fy);
    return std::lerp(std::lerp(corner(0, 0), corner(1, 0), u), std::lerp(corner(0, 1), corner(1, 1), u), v);
}

}  // namespace render
