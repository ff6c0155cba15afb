#pragma once

#include "sim/numbers.h"

namespace sim::inertial {

// The slope of a value across its cell, from the differences to either neighbour: their mean, but no steeper
// than either of them twice, and 0 at an extremum (monotonized central; van Leer 1977). What it carries to a
// face, half of it, lies between the value and its neighbour there, so a value ≥ 0 is at most doubled.
template <class Number>
[[gnu::always_inline]] inline Number monotonized(const Number& back, const Number& ahead) {
    const Number back2 = back + back, ahead2 = ahead + ahead;
    const Number mean = Scalar<Number>(0.5) * (back + ahead);
    const Number least = smaller(smaller(back2, ahead2), mean);
    const Number most = larger(larger(back2, ahead2), mean);
    return larger(least, Number(0)) + smaller(most, Number(0));
}

}  // namespace sim::inertial
