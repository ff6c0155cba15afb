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
    const Number way = (velocity_back + velocity_ahead) * (S(0.5) * c.courant);
    const auto forth = way > S{0};
    const Number from = select(forth, r.back, r.ahead), to = select(forth, r.ahead, r.back);
    const Number behind = select(forth, r.back2, r.ahead2);
    return way * (from + S(0.5) * minmod<Number>(from - behind, to - from));
}

// No less than what a vertex with R of `now` and `then` wants to give to all sides, as the mean of both.
// Where v_f leads away from C on both sides of it, both together are at most V; the greater R there is that
// of the side toward which R falls, at most R_C + ½ (R_C − 0): along each axis 3/2 R V Δt/Δx. V is of the
// vertices beside C, too: it holds in a world of one material.
template <class Number>
[[gnu::always_inline]] inline Number greatest_outflow(const Number& now, const Number& then,
                                                      const Constants<Scalar<Number>>& c) {
    return (now + then) * c.greatest_outflow;
}

}  // namespace sim::bcre
