#pragma once

#include <cstdint>

#include "sim/inertial/exchange.h"
#include "sim/inertial/fields.h"
#include "sim/stages/stages.h"

// Two thresholds (Daerr & Douady 1999). A vertex whose rolling layer is thinner than R_min and slow is at
// rest:
//
//     S > s_start and d + R ≥ R_min   start:   loose or all ground starts, at most start_depth at once
//     else                            freeze:  the thin layer joins the standing one
//
// A layer is slow if its speed allows deposition, |v| ≤ v_dep. Without this condition a front, which is thin
// at its tip, would be stopped more often with shorter sub-steps. A layer of any depth that stands still also
// freezes if the vertex holds afterwards: S + κ R/Δx ≤ s_start.
//
// Natural ground is stronger: a vertex that was steep from the start must become even steeper to start,
//
//     s_start = max(start_slope, anchor_gain S₀ + anchor_margin + anchor_step / Δx).
//
// anchor_step is a height, independent of the cell. An avalanche leaves a scarp of some metres beside a
// vertex, whose slope increases as the grid gets finer. Without the step one scarp would trigger the next
// across a whole face.
//
// Material above the first surface, d > d₀, is loose. It starts on its own above the erosion slope, at which
// a flow would erode it. The ground under it starts only above its own s_start. So a heap dumped on a slope
// starts, however strong the ground under it.

namespace sim::inertial {

inline constexpr float kStandsStill = 1e-3f;  // m/s; a grain on a slope is faster after its first sub-step

// Rows y = 0 … ny-1. Reads drops of u1, first_slope, first_depth; writes d, R, velocity of u0, up to vertex
// `end`. `active`, if given, has one byte per vector of lanes, which is set if anything rolls.
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
                select(left, before / select(left, rolls, Number(1)), none);  // started material is at rest
            store_before<Number>(end, d - moved, depth, i);
            store_before(end, rolls, rolling, i);
            store_before<Number>(end, select(changes, u * kept, u), to_u, i);
            store_before<Number>(end, select(changes, v * kept, v), to_v, i);
        }
        tell(rolls, i);
    };
}

}  // namespace sim::inertial
