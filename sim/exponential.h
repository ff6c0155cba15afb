#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace sim {

// e^x by argument reduction and a polynomial of degree 6 (Taylor): the same bits on every compiler, which the
// C library's exp does not promise. |x| ≤ 80, relative error below 3e-7; beyond, the value at ±80.
inline float exponential(float x) {
    const float bounded = x < -80.f ? -80.f : (x > 80.f ? 80.f : x);
    const float n = std::rint(bounded * 1.44269504f);
    const float r =
        (bounded - n * 0.693359375f) + n * 2.12194440e-4f;  // ln 2 in two parts, so that r keeps its digits
    const float p =
        1.f + r * (1.f + r * (0.5f + r * (1.f / 6 + r * (1.f / 24 + r * (1.f / 120 + r * (1.f / 720))))));
    const auto exponent = static_cast<std::uint32_t>(static_cast<std::int32_t>(n) + 127) << 23;
    return p * std::bit_cast<float>(exponent);
}

inline double exponential(double x) {
    return std::exp(x);  // for verification, which promises no bits
}

}  // namespace sim
