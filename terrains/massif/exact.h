#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "sim/core/angle.h"

// Trigonometry, steps and noise from + − × ÷, square roots, floor and integers only: the same bits on every machine.
namespace terrains::massif {

inline double tangent(double degrees) {
    const sim::Direction direction = sim::direction_of(degrees);
    return direction.x / direction.y;
}

// Smooth step: 0 at `from`, 1 at `to`.
inline double eased(double from, double to, double value) {
    const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

inline double mixed(double a, double b, double t) {
    return a + (b - a) * t;
}

// splitmix64 (Steele, Lea and Flood 2014).
inline std::uint64_t scrambled(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

// Random numbers and gradient noise that depend on the seed, a stream number and a place only.
class Noise {
  public:
    Noise(std::uint64_t seed, std::uint64_t stream) : key_(scrambled(seed ^ scrambled(stream))) {}

    std::uint64_t bits(std::int64_t i, std::int64_t j = 0) const {
        return scrambled(key_ ^ scrambled(static_cast<std::uint64_t>(i) * 0x8da6b343u ^
                                          static_cast<std::uint64_t>(j) * 0xd8163841u << 20));
    }
    double unit(std::int64_t i, std::int64_t j = 0) const {  // 0 to 1
        return static_cast<double>(bits(i, j) >> 11) / 9007199254740992.0;
    }
    double at(double x, double y) const {  // about −1 to 1
        const double fi = std::floor(x), fj = std::floor(y), f = x - fi, g = y - fj;
        const auto i = static_cast<std::int64_t>(fi), j = static_cast<std::int64_t>(fj);
        const double s = f * f * f * (f * (f * 6 - 15) + 10), t = g * g * g * (g * (g * 6 - 15) + 10);
        return 1.3 * mixed(mixed(corner(i, j, f, g), corner(i + 1, j, f - 1, g), s),
                           mixed(corner(i, j + 1, f, g - 1), corner(i + 1, j + 1, f - 1, g - 1), s), t);
    }
    // Octaves, each turned by 53° against the last and half as strong.
    double octaves(double x, double y, int count) const {
        double sum = 0, amplitude = 1;
        for (int k = 0; k < count; ++k, amplitude *= 0.5) {
            sum += amplitude * at(x, y);
            const double turned = 1.2 * x - 1.6 * y;
            y = 1.6 * x + 1.2 * y + 17.3;
            x = turned + 5.1;
        }
        return sum;
    }

  private:
    double corner(std::int64_t i, std::int64_t j, double x, double y) const {
        const std::uint64_t b = bits(i, j);
        const double gx = static_cast<double>(b & 0xffff) / 32767.5 - 1;
        const double gy = static_cast<double>((b >> 16) & 0xffff) / 32767.5 - 1;
        return gx * x + gy * y;
    }
    std::uint64_t key_;
};

}  // namespace terrains::massif
