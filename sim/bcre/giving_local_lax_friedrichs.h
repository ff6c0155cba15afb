#pragma once

#include "sim/bcre/giving.h"

// Local Lax–Friedrichs, split by each vertex's own speed, f± = ½ (R v ± R |v|): a vertex gives whither it
// moves, and nothing the other way.
//
//     e = R v_E Δt/Δx        w, n, s alike
//
// No diffusion where nothing moves. At Courant numbers up to ¼ no more than 0.71 R leaves a vertex, a peak
// with four lower neighbours, so that a layer of 16 quanta has the four that rounding may add; a thinner one
// waits.

namespace sim::bcre {

template <class Number>
Toward<Number> give_local_lax_friedrichs(const Number& rolling, const Toward<Number>& down,
                                         const Number& pace, const Constants<Scalar<Number>>& c) {
    const Number moving = select(rolling >= 16 * kGrain<Number>, rolling, Number(0));
    const Number per_drop = moving * c.courant * pace;
    const Toward<Number> wanted{down.east * per_drop, down.west * per_drop, down.north * per_drop,
                                down.south * per_drop};
    return c.may_give_too_much ? limited(wanted, rolling) : wanted;
}

}  // namespace sim::bcre
