#pragma once

#include <cmath>
#include <cstdint>

#include "sim/simd/numbers.h"
#include "sim/world/ledger.h"

namespace sim {

// A sub-step's length, and the dither with which it rounds to quanta: one number for all of it, equally
// spread over (0, 1) from sub-step to sub-step (golden-ratio sequence). So rounding is right on average over
// time, and a film whose flux is less than a quantum per sub-step still flows. Rounding to nearest would keep
// it in place.
template <class Number>
struct Substep {
    Number dt = 0;        // s
    float dither = 0.5f;  // 0 < dither < 1
};

inline float dither_of(std::int64_t substep) {
    const auto turned = static_cast<std::uint32_t>(substep) * 2654435769u;  // 2³² / golden ratio
    return static_cast<float>((turned >> 8) | 1) * (1.f / 16777216.f);
}

// The nearest whole number of quanta, for what is rounded once.
inline float nearest_quanta(float metres) {
    return std::rint(metres / kQuantum) * kQuantum;
}
inline double nearest_quanta(double metres) {
    return metres;
}

template <class Number>
inline constexpr bool kHasQuanta = !std::is_same_v<Number, double>;

// What rounding may add to a transfer, m.
template <class Number>
inline constexpr Scalar<Number> kGrain = kHasQuanta<Number> ? kQuantum : 0;

// A sub-step's dither as it is added, m, between minus and plus half of a quantum.
template <class Number>
struct Dither {
    Number metres;

    Dither() = default;
    Dither(float dither) : metres((dither - 0.5f) * kQuantum) {}
};

// `metres` as a whole number of quanta, less than one away, and exactly 0 for 0. From 96 m on, float's
// digits end at one quantum: what is added and taken away again leaves whole ones. -32 ≤ metres; from 32 m on
// they are whole pairs.
template <class Number>
[[gnu::always_inline]] inline Number in_quanta(const Number& metres, const Dither<Scalar<Number>>& dither) {
    if constexpr (kHasQuanta<Number>)
        return ((metres + dither.metres) + 96.f) - 96.f;
    else
        return metres;  // double has none, see Layers
}

}  // namespace sim
