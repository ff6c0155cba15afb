#pragma once

#include "sim/bcre/giving.h"

// Lax–Friedrichs, as published: a vertex gives a quarter to each neighbour, more to those it moves toward.
//
//     e = ¼ R + ½ R v_x Δt/Δx        w = ¼ R − ½ R v_x Δt/Δx        n, s alike, with v_x = v_E − v_W
//
// Its defect: a layer at rest spreads all the same, with Δx²/4Δt along each axis, and odd and even vertices
// do not know of each other. Kept for comparison.

namespace sim::bcre {

template <class Number>
Toward<Number> give_lax_friedrichs(const Number& rolling, const Toward<Number>& down, const Number& pace,
                                   const Constants<Scalar<Number>>& c) {
    using S = Scalar<Number>;
    const Number quarter = rolling * S(0.25);
    const Number half_per_drop = rolling * c.courant * pace * S(0.5);
    const Number x = (down.east - down.west) * half_per_drop;
    const Number y = (down.north - down.south) * half_per_drop;
    return limited<Number>({quarter + x, quarter - x, quarter + y, quarter - y}, rolling);
}

}  // namespace sim::bcre
