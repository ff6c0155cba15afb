#pragma once

#include "sim/simd/numbers.h"

// Second order in time (SSP-RK2; Gottlieb, Shu and Tadmor 2001). L is the change by transport and exchange in
// a sub-step:
//
//     u₁ = u₀ + L(u₀)        u = u₀ + ½ (L(u₀) + L(u₁))
//
// The result is a mean of forward sub-steps, so it preserves every invariant that each of them preserves.
// Both stages transfer mass as fluxes and exchange, and so does their mean. Mass is quantised once, at the
// end. u₁ serves only to find L(u₁).

namespace sim::bcre {

// Whether a value is computed from u₀ or from u₁.
enum class RkStage { kFirst, kSecond };

template <class Number>
[[gnu::always_inline]] inline Number mean(const Number& first, const Number& second) {
    return Scalar<Number>(0.5) * (first + second);
}

// R of u₁, from R after transport and the exchange. Clamps rounding errors below 0.
template <class Number>
[[gnu::always_inline]] inline Number predicted_rolling(const Number& carried, const Number& exchanged) {
    return max(carried + exchanged, Number(0));
}

}  // namespace sim::bcre
