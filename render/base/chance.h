#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace render {

// Numbers by chance, from a seed (xorshift).
class Chance {
  public:
    explicit Chance(std::uint32_t seed) : x_(seed * 2654435761u + 12345u) {}
    float operator()() {
        x_ ^= x_ << 13, x_ ^= x_ >> 17, x_ ^= x_ << 5;
        return static_cast<float>(x_ >> 8) / 16777216.f;
    }
    float operator()(float low, float high) { return glm::mix(low, high, (*this)()); }

  private:
    std::uint32_t x_;
};

// Unit vector in plan after so many turns, from a rational circle: no maths library has its own last bits in it.
inline glm::vec3 direction(float turns) {
    const float quarters = 4 * (turns - std::floor(turns)), t = quarters - std::floor(quarters);
    const float c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
    const std::array<glm::vec3, 4> of_quarter{{{c, s, 0}, {-s, c, 0}, {-c, -s, 0}, {s, -c, 0}}};
    return of_quarter[static_cast<std::size_t>(quarters) % 4];
}

}  // namespace render
