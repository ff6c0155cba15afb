#pragma once

#include "sim/bcre/flux.h"

// Lax–Friedrichs, as published: a quarter of a vertex flows to each neighbour, more to those downstream.
//
//     W → C                    F_w = (¼ R + ½ R v_x Δt/Δx)_W − (¼ R − ½ R v_x Δt/Δx)_C
//                              F_s likewise, with v_x = v_E − v_W of velocity.h
//
// At Courant numbers up to ½ both parentheses are ≥ 0, and the four outflows of a vertex sum to its layer.
// The vertex keeps a reserve for rounding. The scheme has two defects: a layer at rest still spreads, with
// diffusivity Δx²/4Δt along each axis, and odd and even vertices decouple. It is kept for comparison.

namespace sim::bcre {

// The outflow of a vertex to each side, m, and what is added forward and subtracted backward on each axis.
template <class Number>
struct Quarters {
    Number quarter, along_x, along_y;
};

template <class Number>
[[gnu::always_inline]] inline Quarters<Number> quarters(const Number& rolling, const Vector<Number>& velocity,
                                                        const Constants<Scalar<Number>>& c) {
    using S = Scalar<Number>;
    const Number moving = max(rolling - kInHand<Number>, Number(0));
    const Number half = moving * (S(0.5) * c.courant);
    return {moving * S(0.25), velocity.x * half, velocity.y * half};
}

// Flux through a face, from the outflows of the vertices on both sides.
template <class Number>
[[gnu::always_inline]] inline Number flux_lax_friedrichs(const Number& quarter_back, const Number& along_back,
                                                         const Number& quarter_ahead,
                                                         const Number& along_ahead) {
    return (quarter_back + along_back) - (quarter_ahead - along_ahead);
}

}  // namespace sim::bcre
