#pragma once

#include "sim/bcre/constants.h"
#include "sim/numbers.h"

// Slope of h = b + d toward the lower neighbours of a vertex, upwind: what lies uphill feels what happens
// below, and a checkerboard is seen.
//
//            N              f_x = max(0, D_W, D_E),  f_y = max(0, D_S, D_N)        S = |f| / Δx
//            |
//   WW — W — C — E — EE     D_W = h_C − h_W  [+ ½ minmod(B_C, B_W)],  B_C = h_E − 2 h_C + h_W
//            |
//            S              lowering C by Δ lowers S by at most √2 Δ/Δx
//
// The term in brackets makes it second order where h is smooth (Osher and Shu 1991); B is 0 where a neighbour
// is not known. Bedrock and depth are differenced apart: their sum would lose the layers' last digits.

namespace sim::bcre {

// Something for each of the four neighbours of a vertex.
template <class Number>
struct Toward {
    Number east, west, north, south;

    Number sum() const { return (east + west) + (north + south); }
};

// Of the drops D those that lead down, m.
template <class Number>
Toward<Number> downward(const Toward<Number>& drop) {
    const Number none(0);
    return {larger(drop.east, none), larger(drop.west, none), larger(drop.north, none),
            larger(drop.south, none)};
}

// |f|, the fall over a cell, m.
template <class Number>
Number fall_of(const Toward<Number>& down) {
    const Number x = larger(down.west, down.east), y = larger(down.south, down.north);
    return square_root(x * x + y * y);
}

// D to second order, from that of first order and the bends B of both vertices.
template <class Number>
Number limited_drop(const Number& drop, const Number& bend_here, const Number& bend_there) {
    return drop + Scalar<Number>(0.5) * minmod<Number>(bend_here, bend_there);
}

}  // namespace sim::bcre
