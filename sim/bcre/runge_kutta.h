#pragma once

#include "sim/bcre/giving.h"

// Second order in time (SSP-RK2; Gottlieb, Shu and Tadmor 2001), with L what transport and exchange do in a
// sub-step:
//
//     u₁ = u₀ + L(u₀)        u = u₀ + ½ (L(u₀) + L(u₁))
//
// As a mean of forward sub-steps it keeps what each of them keeps. What is transferred is a give or an
// exchange in both halves, so the mean of them is too: mass is booked once, at the end, in whole quanta. u₁
// only serves to find L(u₁).

namespace sim::bcre {

template <class Number>
Number mean(const Number& first, const Number& second) {
    return Scalar<Number>(0.5) * (first + second);
}

template <class Number>
Toward<Number> mean(const Toward<Number>& first, const Toward<Number>& second) {
    return {mean(first.east, second.east), mean(first.west, second.west), mean(first.north, second.north),
            mean(first.south, second.south)};
}

// R of u₁, from what transport left and the exchange; a rounding below 0 is none.
template <class Number>
Number predicted_rolling(const Number& carried, const Number& exchanged) {
    return larger(carried + exchanged, Number(0));
}

}  // namespace sim::bcre
