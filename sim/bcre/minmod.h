#pragma once

#include <cmath>

namespace sim::bcre {

// The gentler of two slopes of the same sign, else 0 (Roe 1986): what keeps a reconstruction between its
// neighbours.
template <class Number>
Number minmod(Number a, Number b) {
    const Number smaller = std::fabs(a) < std::fabs(b) ? a : b;
    return a * b > 0 ? smaller : Number{0};
}

}  // namespace sim::bcre
