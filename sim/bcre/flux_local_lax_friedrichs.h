#pragma once

#include "sim/bcre/flux.h"

// Local Lax–Friedrichs, split by each vertex's own speed, f± = ½ (R v ± R |v|): material leaves a vertex only
// in its direction of motion. Only one side of a face is the lower one, so the flux comes from the other
// side:
//
//     W → C                    F_w = R_W v_E(W) Δt/Δx     if the ground falls to the east,  D > 0
//         D = h_W − h_C            = −R_C v_W(C) Δt/Δx    if it falls to the west;
//                              F_s likewise
//
// Material at rest does not diffuse. At Courant numbers up to ¼ at most 0.71 R leaves a vertex; the extreme
// is a peak with four lower neighbours. So a layer of 16 quanta keeps the four that rounding may add. A
// thinner layer does not flow.

namespace sim::bcre {

// R k Δt/Δx: the outflow of a vertex to one side, m, per metre of drop to that side.
template <class Number>
[[gnu::always_inline]] inline Number outflow_per_drop(const Number& rolling, const Number& pace,
                                                      const Constants<Scalar<Number>>& c) {
    const Number moving = select(rolling >= 16 * kGrain<Number>, rolling, Number(0));
    return moving * c.courant * pace;
}

// `back` and `ahead`: outflow_per_drop of the vertices on both sides.
template <class Number>
[[gnu::always_inline]] inline Number flux_local_lax_friedrichs(const Number& drop, const Number& back,
                                                               const Number& ahead) {
    return drop * select(drop > 0, back, ahead);
}

}  // namespace sim::bcre
