#pragma once

#include "sim/simd/numbers.h"

namespace sim::inertial {

// Half the limited slope of a value across its cell, from the differences to both neighbours. The slope is
// their mean, but at most twice either difference, and 0 at an extremum (monotonized central; van Leer 1977).
// The value at a face lies between those of its two vertices, so a value ≥ 0 is at most doubled.
template <class Number>
[[gnu::always_inline]] inline Number half_monotonized(const Number& back, const Number& ahead) {
    const Number half_mean = Scalar<Number>(0.25) * (back + ahead);
    return if_same_sign(back, ahead, min_magnitude(min_magnitude(back, ahead), half_mean));
}

}  // namespace sim::inertial
