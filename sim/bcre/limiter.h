#pragma once

#include <algorithm>
#include <cmath>

namespace sim::bcre {

// The slope of a value across its cell, from the differences to either neighbour: their mean, but no steeper
// than either of them twice, and 0 at an extremum (monotonized central; van Leer 1977). What it carries to a
// face, half of it, lies between the value and its neighbour there, so a value ≥ 0 is at most doubled.
template <class Number>
Number monotonized(Number back, Number ahead) {
    const Number gentlest = 2 * std::min(std::fabs(back), std::fabs(ahead));
    const Number mean = Number{0.5f} * std::fabs(back + ahead);
    return back * ahead > 0 ? std::copysign(std::min(gentlest, mean), back) : Number{0};
}

}  // namespace sim::bcre
