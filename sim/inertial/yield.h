#pragma once

#include <cstdint>

#include "sim/inertial/exchange.h"
#include "sim/inertial/fields.h"
#include "sim/stages/stages.h"

// Two thresholds (Daerr & Douady 1999). A vertex whose rolling layer is thinner than R_min and slow is at
// rest:
//
//     S > s_start and d + R ≥ R_min   start:   what can start does, no more than start_depth at once
//     else                            freeze:  the thin layer joins the standing one
//
// Slow is what deposits; without that a front, which is thin where it arrives, would be stopped the more
// often the shorter the sub-step. A layer of any depth that stands still freezes too if the vertex holds when
// it has: S + κ R/Δx ≤ s_start.
//
// Natural ground holds: a vertex that was steep from the first starts only when it has become steeper yet,
//
//     s_start = max(start_slope, anchor_gain S₀ + anchor_margin + anchor_step / Δx).
//
// The step is a height, whatever the cell: what an avalanche has bared beside a vertex is a scarp of so many
// metres, the steeper the finer the grid, and one would set off the next all over a face.
//
// Only natural ground holds so. What lies above the first surface, d > d₀, is loose: it starts above the
// erosion slope, at which a flow would take it up, and by itself; the ground under it only above its own
// s_start. So a heap tipped on a slope goes, whatever the slope under it holds.

namespace sim::inertial {

inline constexpr float kStandsStill = 1e-3f;  // m/s; a grain on a slope is faster after its first sub-step

// Rows y = 0 … ny-1. Reads drops of `then`, first_slope, first_depth; writes d, R, velocity, up to vertex
// `end`. `active`, if there is one: a byte for each run of lanes, set where anything rolls.
template <class Number, class S = Scalar<Number>>
auto yield(const StageRows<S>& w, StateRows<S>& u0, int y, int end, std::uint8_t* active = nullptr) {
    const auto tell = [end, active](const Number& rolls, int i) {
        if (active && any_before(end - i, rolls > S{0}))
            active[static_cast<unsigned>(i) / kLanes<Number>] = 1;
    };
    return [c = w.c, drop_x = w.u1.drop_x[y], south = w.u1.drop_y[y], north = w.u1.drop_y[y + 1],
            first_slope = w.first_slope[y], first_depth = w.first_depth[y], depth = u0.depth[y],
            rolling = u0.rolling[y], to_u = u0.velocity_x[y], to_v = u0.velocity_y[y], end, tell](int i) {
        const Number none(0), d = at<Number>(depth, i), before = at<Number>(rolling, i);
        const Number u = at<Number>(to_u, i), v = at<Number>(to_v, i), speed_squared = u * u + v * v;
        const auto thin = before < c.freeze_depth;
        const auto slow = speed_squared < S(kStandsStill * kStandsStill);
        if (!any(thin || slow)) return tell(before, i);
        const Slope<Number> slope = slope_of(outward<Number>(drop_x, south, north, i), c.per_cell);

        const Number loose = d - at<Number>(first_depth, i);
        const Number holds =
            max(c.anchor_gain * at<Number>(first_slope, i) + c.anchor_margin, Number(c.start_slope));
        const auto lies_loose = loose > S{0} && loose + before >= c.freeze_depth;
        const Number start_slope = select(lies_loose, min(holds, Number(c.erosion_slope)), holds);
        const auto stands = slow && slope.tangent + slope.spread * before * c.per_cell <= start_slope;
        const auto at_rest = thin || stands;
        const auto starts = slope.tangent > start_slope && d + before >= c.freeze_depth;
        const auto freezes = before > S{0} && speed_squared <= c.slow_squared;
        const auto changes = at_rest && (starts || freezes);

        const Number can_start = select(slope.tangent > holds, d, loose);
        const Number moved =
            select(changes, select(starts, min(can_start, Number(c.start_depth)), -before), none);
        const Number rolls = before + moved;
        if (any_before(end - i, changes)) {
            const auto left = rolls > S{0};
            const Number kept =
                select(left, before / select(left, rolls, Number(1)), none);  // what starts is at rest
            store_before<Number>(end, d - moved, depth, i);
            store_before(end, rolls, rolling, i);
            store_before<Number>(end, select(changes, u * kept, u), to_u, i);
            store_before<Number>(end, select(changes, v * kept, v), to_v, i);
        }
        tell(rolls, i);
    };
}

}  // namespace sim::inertial
