#pragma once

#include "sim/bcre/flux.h"

// Upwind fluxes from the layer and velocity at the face, second order in space if both are smooth. R follows
// its minmod-limited slope (van Leer 1979); v is the mean of both sides.
//
//     WW    W  |  C    E       v_f = ½ (v_W + v_C)            components along x; σ too
//              |               F_w = (R_W + ½ σ_W) v_f Δt/Δx  if v_f > 0
//              F_w                 = (R_C − ½ σ_C) v_f Δt/Δx  if v_f < 0;     F_s likewise
//                              σ_C = minmod(R_C − R_W, R_E − R_C)

namespace sim::bcre {

// Four values along one axis, from west to east or from south to north.
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

// An upper bound of the mean outflow of a vertex to all sides, with R of u0 (`now`) and u1 (`then`). If v_f
// leads away from C on both sides, the two together are at most V. The greater R at a face is on the side
// toward which R falls, at most R_C + ½ (R_C − 0). So the bound is 3/2 R V Δt/Δx along each axis. V must also
// hold for the neighbours of C, so the bound is valid only in a world of one material.
template <class Number>
[[gnu::always_inline]] inline Number greatest_outflow(const Number& now, const Number& then,
                                                      const Constants<Scalar<Number>>& c) {
    return (now + then) * c.greatest_outflow;
}

}  // namespace sim::bcre
