#pragma once

#include "sim/bcre/flux.h"

// Lax–Friedrichs, as published: a vertex gives a quarter to each neighbour, more to those it moves toward.
//
//     W → C                    F_w = (¼ R + ½ R v_x Δt/Δx)_W − (¼ R − ½ R v_x Δt/Δx)_C
//                              F_s alike, with v_x = v_E − v_W of velocity.h
//
// At Courant numbers up to ½ both parentheses are ≥ 0, and the four of a vertex are together what it has. Of
// that it keeps what rounding may add. Its defect: a layer at rest spreads all the same, with Δx²/4Δt along
// each axis, and odd and even vertices do not know of each other. Kept for comparison.

namespace sim::bcre {

// What a vertex gives to each side, m, and how much more forth and less back along either axis.
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

// From the vertices on both sides.
template <class Number>
[[gnu::always_inline]] inline Number flux_lax_friedrichs(const Number& quarter_back, const Number& along_back,
                                                         const Number& quarter_ahead,
                                                         const Number& along_ahead) {
    return (quarter_back + along_back) - (quarter_ahead - along_ahead);
}

}  // namespace sim::bcre
