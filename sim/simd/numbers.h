#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

// The standard library's data-parallel types: one formula for one number and for many.
#if defined(_LIBCPP_VERSION)
#include "sim/simd/vectors.h"
#else
#include <experimental/simd>
#endif

// Operations for formulas that are written once for several number types: float in a world, double in
// verification, and lanes of floats in a sweep (Lanes). All are correctly rounded by IEEE 754, so each lane
// is bit-identical to a float.

namespace sim {

#if defined(_LIBCPP_VERSION)
namespace stdx = vectors;
#else
namespace stdx = std::experimental;
#endif

template <class Number>
inline constexpr bool kIsLanes = stdx::is_simd_v<Number>;

// The type of constants: float for float and its lanes, double for double.
template <class Number>
using Scalar = std::conditional_t<std::is_same_v<Number, double>, double, float>;

template <class Number>
using Same = std::type_identity_t<Number>;  // a non-deduced parameter

[[gnu::always_inline]] inline bool any(bool condition) {
    return condition;
}
template <class T, class Abi>
[[gnu::always_inline]] inline bool any(const stdx::simd_mask<T, Abi>& condition) {
    return stdx::any_of(condition);
}

// Mask of the first `count` lanes, count ≥ 1.
template <class Number>
[[gnu::always_inline]] inline auto first_lanes(int count) {
    const Number number([](auto lane) { return static_cast<float>(lane); });
    return number < static_cast<float>(count);
}

// True if the condition holds in one of the first `count` lanes.
[[gnu::always_inline]] inline bool any_before(int, bool condition) {
    return condition;
}
template <class T, class Abi>
[[gnu::always_inline]] inline bool any_before(int count, const stdx::simd_mask<T, Abi>& condition) {
    return stdx::any_of(condition && first_lanes<stdx::simd<T, Abi>>(count));
}

// How many of the first `count` lanes fulfil the condition.
[[gnu::always_inline]] inline int count_before(int, bool condition) {
    return condition ? 1 : 0;
}
template <class T, class Abi>
[[gnu::always_inline]] inline int count_before(int count, const stdx::simd_mask<T, Abi>& condition) {
    return stdx::popcount(condition && first_lanes<stdx::simd<T, Abi>>(count));
}

// Per lane: `yes` if the condition holds, else `no`.
template <class Condition, class Number>
[[gnu::always_inline]] inline Number select(const Condition& condition, const Number& yes,
                                            const Same<Number>& no) {
    if constexpr (std::is_same_v<Condition, bool>) {
        return condition ? yes : no;
    } else {
        Number chosen = no;
        stdx::where(condition, chosen) = yes;
        return chosen;
    }
}

// NOLINTBEGIN(readability-identifier-naming): these are called as functions.

// The standard operations, lane by lane. They are objects that are called, because the lookup of a function
// would also find the library's own overloads for lanes: exp and expm1 of these call the C library for each
// lane.
inline constexpr struct Max {
    template <class Number>
    [[gnu::always_inline]] Number operator()(const Number& a, const Same<Number>& b) const {
        if constexpr (kIsLanes<Number>)
            return stdx::max(a, b);
        else
            return a < b ? b : a;
    }
} max;

inline constexpr struct Min {
    template <class Number>
    [[gnu::always_inline]] Number operator()(const Number& a, const Same<Number>& b) const {
        if constexpr (kIsLanes<Number>)
            return stdx::min(a, b);
        else
            return b < a ? b : a;
    }
} min;

inline constexpr struct Abs {
    template <class Number>
    [[gnu::always_inline]] Number operator()(const Number& a) const {
        if constexpr (kIsLanes<Number>)
            return stdx::abs(a);
        else
            return std::fabs(a);
    }
} abs;

inline constexpr struct Sqrt {
    template <class Number>
    [[gnu::always_inline]] Number operator()(const Number& a) const {
        if constexpr (kIsLanes<Number>)
            return stdx::sqrt(a);
        else
            return std::sqrt(a);
    }
} sqrt;

inline constexpr struct Floor {
    template <class Number>
    [[gnu::always_inline]] Number operator()(const Number& a) const {
        if constexpr (kIsLanes<Number>)
            return stdx::floor(a);
        else
            return std::floor(a);
    }
} floor;
// NOLINTEND(readability-identifier-naming)

// 2^n for whole n from -126 to 127.
template <class Number>
[[gnu::always_inline]] inline Number power_of_two(const Number& n) {
    if constexpr (kIsLanes<Number>) {
        using Whole = stdx::rebind_simd_t<std::int32_t, Number>;
        return std::bit_cast<Number>(Whole((stdx::static_simd_cast<Whole>(n) + 127) << 23));
    } else {
        return std::bit_cast<float>((static_cast<std::int32_t>(n) + 127) << 23);
    }
}

// Per lane: `of_magnitude`(|a|), which must be ≥ 0, with the sign of a.
template <class Number, class OfMagnitude>
[[gnu::always_inline]] inline Number with_its_sign(const Number& a, OfMagnitude of_magnitude) {
    if constexpr (kIsLanes<Number>) {
        using Bits = stdx::rebind_simd_t<std::uint32_t, Number>;
        const Bits bits = std::bit_cast<Bits>(a), sign = bits & Bits(0x80000000u);
        const Number result = of_magnitude(std::bit_cast<Number>(Bits(bits ^ sign)));
        return std::bit_cast<Number>(Bits(std::bit_cast<Bits>(result) ^ sign));
    } else {
        return std::copysign(of_magnitude(std::fabs(a)), a);
    }
}

// The nearer to 0 of two numbers with the same sign. Their bits, as integers, have that order for either
// sign.
template <class Number>
[[gnu::always_inline]] inline Number min_magnitude(const Number& a, const Number& b) {
    if constexpr (kIsLanes<Number>) {
        using Bits = stdx::rebind_simd_t<std::int32_t, Number>;
        return std::bit_cast<Number>(Bits(stdx::min(std::bit_cast<Bits>(a), std::bit_cast<Bits>(b))));
    } else {
        return std::fabs(b) < std::fabs(a) ? b : a;
    }
}

// `value` if a and b have the same sign, else 0.
template <class Number>
[[gnu::always_inline]] inline Number if_same_sign(const Number& a, const Number& b, const Number& value) {
    if constexpr (kIsLanes<Number>) {
        using Bits = stdx::rebind_simd_t<std::int32_t, Number>;
        const Bits differ = (std::bit_cast<Bits>(a) ^ std::bit_cast<Bits>(b)) >> 31;  // all bits or none
        return std::bit_cast<Number>(Bits(std::bit_cast<Bits>(value) & ~differ));
    } else {
        return std::signbit(a) == std::signbit(b) ? value : Number(0);
    }
}

// The gentler of two slopes of the same sign, else 0 (minmod, Roe 1986). Keeps a reconstruction between its
// neighbours.
template <class Number>
[[gnu::always_inline]] inline Number minmod(const Number& a, const Number& b) {
    return if_same_sign(a, b, min_magnitude(a, b));
}

}  // namespace sim
