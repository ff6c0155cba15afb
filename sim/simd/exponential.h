#pragma once

#include <cmath>

#include "sim/simd/numbers.h"

namespace sim {

// NOLINTBEGIN(readability-identifier-naming): these are called as functions.
// e^x by argument reduction and a polynomial of degree 6 (Taylor). Its bits are the same with every compiler,
// which the C library's exp does not promise. |x| ≤ 80, relative error below 3e-7; beyond, the value at ±80.
inline constexpr struct Exp {
    template <class Number>
    [[gnu::always_inline]] Number operator()(const Number& x) const {
        if constexpr (std::is_same_v<Number, double>) {
            return std::exp(x);  // verification alone uses double, and promises no bits
        } else {
            const Number bounded = min(max(x, Number(-80.f)), Number(80.f));
            const Number n = floor(Number(bounded * 1.44269504f + 0.5f));
            // ln 2 in two parts, so that r keeps its digits
            const Number r = (bounded - n * 0.693359375f) + n * 2.12194440e-4f;
            const Number p =
                1.f +
                r * (1.f + r * (0.5f + r * (1.f / 6 + r * (1.f / 24 + r * (1.f / 120 + r * (1.f / 720))))));
            return p * power_of_two(n);
        }
    }
} exp;

// e^x − 1 for |x| ≤ kExpm1Small by a polynomial of degree 4 (Taylor), relative error below 2.1e-6.
inline constexpr double kExpm1Small = 0.125;
inline constexpr struct Expm1Small {
    template <class Number>
    [[gnu::always_inline]] Number operator()(const Number& x) const {
        if constexpr (std::is_same_v<Number, double>) {
            return std::expm1(x);
        } else {
            return x * ((x * 0.5f + 1.f) + (x * x) * (x * (1.f / 24) + 1.f / 6));
        }
    }
} expm1_small;

// e^x − 1, with full precision where it is small.
inline constexpr struct Expm1 {
    template <class Number>
    [[gnu::always_inline]] Number operator()(const Number& x) const {
        if constexpr (std::is_same_v<Number, double>) {
            return std::expm1(x);
        } else {
            const auto large = abs(x) > static_cast<float>(kExpm1Small);
            return select(large, exp(x) - 1.f, expm1_small(x));
        }
    }
} expm1;
// NOLINTEND(readability-identifier-naming)

}  // namespace sim
