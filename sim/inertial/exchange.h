#pragma once

#include "sim/inertial/fields.h"
#include "sim/stages/stages.h"

// Exchange between the layers, erosion positive. S is the slope of h toward the lower neighbours:
//
//     S > s_ero:      Γ = +γ min(R_e, R_c) (S − s_ero)                R_e = max(0, R − R_ero)² / R
//     S < s_stop(R):  Γ = −γ min(R, R_c) (s_stop − S) max(0, 1 − |v|/v_dep)
//     s_stop(R) = s_thick + (s_thin − s_thick) e^(−R/R_fold)
//
// Between s_stop and s_ero nothing is exchanged. The speed gate, not inertia, carries a flow over benches and
// pits. Erosion begins smoothly as R passes R_ero. With a jump or a kink, the thin edges of a flow would
// amplify grid noise, and outlines would show the grid.
//
//            N              D_W = h_C − h_W
//            |              S first order:   g_x = max(0, D_W, D_E) / Δx,  |g|;  only for yield, because the
//   WW — W — C — E — EE                      strength of natural ground is measured with it
//            |              S second order:  D_W + ½ minmod(h_E − 2 h_C + h_W, h_C − 2 h_W + h_WW)  for D_W;
//            S                               used for Γ (Osher and Shu 1991)
//
// κ = (g_x + g_y)/|g|: lowering C by Δ lowers S by at most κ Δ/Δx; raising C raises S by at most √2 Δ/Δx. So
// neither erosion nor deposition takes S past its threshold. Beyond the halo nothing is known, so the minmod
// term is 0 there.

namespace sim::inertial {

// S toward the lower neighbours, and the spread κ = (g_x + g_y)/|g|, 1 to √2.
template <class Number>
struct Slope {
    Number tangent, spread;
};
template <class Number>
[[gnu::always_inline]] inline Slope<Number> slope_of(const Drops<Number>& drop, Scalar<Number> per_cell) {
    const Number none(0);
    const Number gx = max(max(drop.west, drop.east), none) * per_cell;
    const Number gy = max(max(drop.south, drop.north), none) * per_cell;
    const Number tangent = sqrt(gx * gx + gy * gy);
    const auto leads_down = tangent > 0;
    return {tangent, select(leads_down, (gx + gy) / select(leads_down, tangent, Number(1)), Number(1))};
}

// Rows y = 0 … ny-1. Reads d, R, velocity, drops and curvature of a state; writes exchanged, the exchange of
// a sub-step at the state's rate.
template <class Number, class S = Scalar<Number>>
auto find_exchange(const StageRows<S>& w, const StateRows<S>& level, Rows<S>& exchanged, int y) {
    constexpr S kGreatestSpread = S(1.41421356237309505);
    return [c = w.c, drop_x = level.drop_x[y], south = level.drop_y[y], north = level.drop_y[y + 1],
            curvature_x = level.curvature_x[y], curvature_south = level.curvature_y[y],
            curvature_north = level.curvature_y[y + 1], depth = level.depth[y], rolling = level.rolling[y],
            to_u = level.velocity_x[y], to_v = level.velocity_y[y], to = exchanged[y]](int i) {
        const Number none(0), r = at<Number>(rolling, i);
        if (!any(r > S{0})) {
            store(none, to + i);
            return;
        }
        const Drops<Number> drop = outward<Number>(drop_x, south, north, i);
        const Number slope =
            slope_dx_of<Number>(
                {drop.east + at<Number>(curvature_x, i + 1), drop.west + at<Number>(curvature_x, i),
                 drop.north + at<Number>(curvature_north, i), drop.south + at<Number>(curvature_south, i)}) *
            c.per_cell;
        const Number steep = max(slope - c.erosion_slope, none);
        Number eroded = none, laid = none;
        if (any(steep > S{0})) {
            const Number above = max(r - c.erosion_depth, none);
            const Number erodes = min(above * above / max(r, Number(S(kNothing))), Number(c.exchange_depth));
            const Number pace = c.pace * erodes;
            eroded = min(pace * steep, at<Number>(depth, i));
            if (any(pace > S(0.99) / kGreatestSpread * c.dx))  // otherwise S stays above its threshold
                eroded = min(eroded, steep * c.dx / slope_of(drop, c.per_cell).spread);
        }
        if (any(slope < c.greatest_stop_slope)) {
            const Number stop = c.stop_slope_thick + c.stop_slope_more * exp(-r * c.per_fold_depth);
            const Number gentle = max(stop - slope, none);
            const Number u = at<Number>(to_u, i), v = at<Number>(to_v, i);
            const Number gate = max(Number(1) - sqrt(u * u + v * v) * c.per_deposit_speed, none);
            laid = min(c.pace * gate * min(r, Number(c.exchange_depth)) * gentle,
                       gentle * (c.dx / kGreatestSpread));
        }
        store<Number>(eroded - min(laid, r), to + i);
    };
}

}  // namespace sim::inertial
