#pragma once

#include "sim/simd/numbers.h"

// Second order in time (SSP-RK2; Gottlieb, Shu and Tadmor 2001), with L what transport and exchange do in a
// sub-step:
//
//     u₁ = u₀ + L(u₀)        u = u₀ + ½ (L(u₀) + L(u₁))
//
// As a mean of forward sub-steps it keeps what each of them keeps. What is transferred is a flux or an
// exchange in both halves, so the mean of them is too: mass is booked once, at the end, in whole quanta. u₁
// only serves to find L(u₁).

namespace sim::bcre {

// What is reckoned with u₀, and what with u₁.
enum class RkStage { kFirst, kSecond };

template <class Number>
[[gnu::always_inline]] inline Number mean(const Number& first, const Number& second) {
    return Scalar<Number>(0.5) * (first + second);
}

// R of u₁, from what transport left and the exchange; a rounding below 0 is none.
template <class Number>
[[gnu::always_inline]] inline Number predicted_rolling(const Number& carried, const Number& exchanged) {
    return max(carried + exchanged, Number(0));
}

}  // namespace sim::bcre
