#pragma once

#include "sim/bcre/constants.h"
#include "sim/stages/slope.h"

// Two thresholds (Daerr & Douady 1999). A vertex whose rolling layer is thinner than R_min is at rest:
//
//     S > s_start and d + R ≥ R_min   start:   min(d, start_depth) begins to roll
//     else                            freeze:  the thin layer joins the standing one
//
// So a pile between its two thresholds comes to rest exactly and leaves no denormals. A total depth below
// R_min stays on any slope, like dust.

namespace sim::bcre {

template <class Number>
[[gnu::always_inline]] inline void yield(const Number& slope_dx, Number& depth, Number& rolling,
                                         const Constants<Scalar<Number>>& c) {
    const auto at_rest = rolling < c.freeze_depth;
    if (!any(at_rest)) return;
    const auto starts = slope_dx > c.start_slope_dx && depth + rolling >= c.freeze_depth;
    const Number set_free = select(starts, min(depth, Number(c.start_depth)), -rolling);
    const Number moved = select(at_rest, set_free, Number(0));
    depth -= moved;
    rolling += moved;
}

}  // namespace sim::bcre
