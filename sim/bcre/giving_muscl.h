#pragma once

#include "sim/bcre/giving.h"

// The split fluxes of giving_local_lax_friedrichs.h with layer and velocity of the face, second order in
// space where they are smooth: R along its minmod-limited slope (van Leer 1979), v as the mean of both sides.
//
//     W     C  |  E            e = (R_C + ½ σ) max(0,  ½ (v_C + v_E)) Δt/Δx        v, σ: components along x
//                              w = (R_C − ½ σ) max(0, −½ (v_C + v_W)) Δt/Δx        n, s alike
//                              σ = minmod(R_C − R_W, R_E − R_C)

namespace sim::bcre {

// Along one axis, from west to east or from south to north.
template <class Number>
struct Line {
    Number back, here, forth;
};

// What a vertex wants to give along an axis.
template <class Number>
struct Gives {
    Number forth, back;
};

template <class Number>
Gives<Number> give_muscl(const Line<Number>& rolling, const Line<Number>& velocity,
                         const Constants<Scalar<Number>>& c) {
    using S = Scalar<Number>;
    const auto& [r_back, r, r_forth] = rolling;
    const auto& [v_back, v, v_forth] = velocity;
    const Number to_face = S(0.5) * minmod<Number>(r - r_back, r_forth - r);
    const Number none(0);
    const S half = S(0.5) * c.courant;
    return {(r + to_face) * larger((v + v_forth) * half, none),
            (r - to_face) * larger((v + v_back) * -half, none)};
}

}  // namespace sim::bcre
