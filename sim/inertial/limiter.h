#pragma once

#include "sim/simd/numbers.h"

namespace sim::inertial {

// Half of the slope of a value across its cell, which is what it carries to a face, from the differences to
// either neighbour: the slope is their mean, but no steeper than either of them twice, and 0 at an extremum
// (monotonized central; van Leer 1977). At a face the value lies between those beside it, so a value ≥ 0 is
// at most doubled.
template <class Number>
[[gnu::always_inline]] inline Number half_monotonized(const Number& back, const Number& ahead) {
    const Number half_mean = Scalar<Number>(0.25) * (back + ahead);
    return if_same_sign(back, ahead, min_magnitude(min_magnitude(back, ahead), half_mean));
}

}  // namespace sim::inertial
