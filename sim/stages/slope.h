#pragma once

#include "sim/simd/numbers.h"

// Slope of h = b + d toward the lower neighbours of a vertex, upwind: a vertex responds to changes below it,
// and a checkerboard has a slope.
//
//            N              f_x = max(0, D_W, D_E),  f_y = max(0, D_S, D_N)        S = |f| / Δx
//            |
//   WW — W — C — E — EE     D_W = h_C − h_W  [+ ½ minmod(B_C, B_W)],  B_C = h_E − 2 h_C + h_W
//            |
//            S              lowering C by Δ lowers S by at most √2 Δ/Δx
//
// The term in brackets makes it second order where h is smooth (Osher and Shu 1991); B is 0 where a neighbour
// is not known. Bedrock and depth are differenced separately, because their sum would lose the last digits of
// the layers.

namespace sim {

// The drops to the four neighbours, m.
template <class Number>
struct Drops {
    Number east, west, north, south;
};

// |f|, the slope times Δx, m.
template <class Number>
[[gnu::always_inline]] inline Number slope_dx_of(const Drops<Number>& drop) {
    const Number x = max(max(drop.west, drop.east), Number(0));
    const Number y = max(max(drop.south, drop.north), Number(0));
    return sqrt(x * x + y * y);
}

// ½ minmod of the curvatures on both sides of a face, which makes its drop second order in either direction.
// `drop` is through the face, the others through the faces before and after it.
template <class Number>
[[gnu::always_inline]] inline Number curvature_correction(const Number& drop_back, const Number& drop,
                                                          const Number& drop_ahead) {
    return Scalar<Number>(0.5) * minmod<Number>(drop_back - drop, drop - drop_ahead);
}

}  // namespace sim
