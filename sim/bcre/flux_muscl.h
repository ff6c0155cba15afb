#pragma once

#include "sim/bcre/flux.h"

// The split fluxes of flux_local_lax_friedrichs.h with layer and velocity of the face, second order in space
// where they are smooth: R along its minmod-limited slope (van Leer 1979), v as the mean of both sides.
//
//     WW    W  |  C    E       v_f = ½ (v_W + v_C)            components along x; σ too
//              |               F_w = (R_W + ½ σ_W) v_f Δt/Δx  where v_f > 0
//              F_w                 = (R_C − ½ σ_C) v_f Δt/Δx  where v_f < 0;     F_s alike
//                              σ_C = minmod(R_C − R_W, R_E − R_C)

namespace sim::bcre {

// Along one axis, from west to east or from south to north.
template <class Number>
struct Line {
    Number back2, back, ahead, ahead2;
};

template <class Number>
[[gnu::always_inline]] inline Number flux_muscl(const Line<Number>& r, const Number& velocity_back,
                                                const Number& velocity_ahead,
                                                const Constants<Scalar<Number>>& c) {
    using S = Scalar<Number>;
    const Number across = r.ahead - r.back, way = (velocity_back + velocity_ahead) * (S(0.5) * c.courant);
    const auto forth = way > S{0};
    const Number beyond = select(forth, r.back - r.back2, r.ahead2 - r.ahead);
    const Number half_slope = S(0.5) * minmod<Number>(beyond, across);
    return way * select(forth, r.back + half_slope, r.ahead - half_slope);
}

}  // namespace sim::bcre
