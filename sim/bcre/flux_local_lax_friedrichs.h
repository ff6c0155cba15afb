#pragma once

#include "sim/bcre/flux.h"

// Local Lax–Friedrichs, split by each vertex's own speed, f± = ½ (R v ± R |v|): a vertex gives whither it
// moves, and nothing the other way. Down is toward one side of a face only, and that side's other one gives:
//
//     W → C                    F_w = R_W v_E(W) Δt/Δx     where the ground falls to the east,  D > 0
//         D = h_W − h_C            = −R_C v_W(C) Δt/Δx    where it falls to the west;
//                              F_s alike
//
// No diffusion where nothing moves. At Courant numbers up to ¼ no more than 0.71 R leaves a vertex, a peak
// with four lower neighbours, so that a layer of 16 quanta has the four that rounding may add; a thinner one
// waits.

namespace sim::bcre {

// R k Δt/Δx: what a vertex gives to a side, m, per metre that it falls to there.
template <class Number>
[[gnu::always_inline]] inline Number outflow_per_drop(const Number& rolling, const Number& pace,
                                                      const Constants<Scalar<Number>>& c) {
    const Number moving = select(rolling >= 16 * kGrain<Number>, rolling, Number(0));
    return moving * c.courant * pace;
}

// `back` and `ahead`: given_per_drop of the vertices on both sides.
template <class Number>
[[gnu::always_inline]] inline Number flux_local_lax_friedrichs(const Number& drop, const Number& back,
                                                               const Number& ahead) {
    return drop * select(drop > 0, back, ahead);
}

}  // namespace sim::bcre
