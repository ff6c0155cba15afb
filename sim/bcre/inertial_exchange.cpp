#include <algorithm>
#include <cmath>

#include "sim/bcre/inertial.h"
#include "sim/exponential.h"
#include "sim/layers.h"
#include "sim/numbers.h"
#include "sim/params.h"
#include "sim/quanta.h"
#include "sim/scratch.h"

// Exchange between the layers, S the slope of h toward its lower neighbours, erosion positive:
//
//     S > s_ero:      Γ = +γ min(R_e, R_c) (S − s_ero)                R_e = max(0, R − R_ero)² / R
//     S < s_stop(R):  Γ = −γ min(R, R_c) (s_stop − S) max(0, 1 − |v|/v_dep)
//     s_stop(R) = s_thick + (s_thin − s_thick) e^(−R/R_fold)
//
// Between s_stop and s_ero nothing is exchanged. The speed gate, not inertia, carries a flow over benches and
// pits. Erosion sets in smoothly where R passes R_ero: by a leap, or with a kink, the edges of a flow, thin
// as they are, grow by what the grid does to them, and outlines show the grid.
//
//            N              D_W = h_C − h_W
//            |              S first order:   g_x = max(0, D_W, D_E) / Δx,  |g|;  what natural ground holds is
//   WW — W — C — E — EE                      measured by it, so it is left to yield
//            |              S second order:  D_W + ½ minmod(h_E − 2 h_C + h_W, h_C − 2 h_W + h_WW)  for D_W;
//            S                               what Γ reckons with (Osher and Shu 1991)
//
// κ = (g_x + g_y)/|g|: lowering C by Δ lowers S by at most κ Δ/Δx, raising raises it by at most √2 Δ/Δx. So
// neither erosion nor deposition takes S past its threshold. Beyond the halo nothing is known, and the
// term with minmod is left out.

namespace sim::bcre {
namespace {

// The fall of h from one vertex to another; bedrock and depth apart, lest the depth's last digits be lost.
template <class Number>
Number fall(const Layers<Number>& s, int x0, int y0, int x1, int y1) {
    return (s.bedrock(x0, y0) - s.bedrock(x1, y1)) + (s.depth(x0, y0) - s.depth(x1, y1));
}

// By how much less h falls beyond a neighbour, which lies by (step_x, step_y), than to it.
template <class Number>
Number bend_beyond(const Layers<Number>& s, int x, int y, int step_x, int step_y, Number to_neighbour) {
    const int far_x = x + 2 * step_x, far_y = y + 2 * step_y;
    if (far_x < -1 || far_y < -1 || far_x > s.grid.nx || far_y > s.grid.ny) return 0;
    return to_neighbour - fall(s, x + step_x, y + step_y, far_x, far_y);
}

// g along one axis, times Δx.
template <class Number>
Number greatest(Number one, Number other) {
    return std::max(Number{0}, std::max(one, other));
}

}  // namespace

template <class Number>
void inertial_exchange(const Layers<Number>& s, const Params& params, Scratch<Number>& scratch,
                       Substep<Number> sub, int first, int last) {
    constexpr Number kGreatestSpread = 1.41421356f, kHalf = 0.5f;
    const Number dx = s.grid.dx, per_cell = 1 / dx, pace = params.exchange_rate * sub.dt;
    const Number reach = params.exchange_depth;
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            const Number west = fall(s, x, y, x - 1, y), east = fall(s, x, y, x + 1, y);
            const Number south = fall(s, x, y, x, y - 1), north = fall(s, x, y, x, y + 1);
            const Number gx = greatest(west, east) * per_cell, gy = greatest(south, north) * per_cell;
            const Number lower = std::sqrt(gx * gx + gy * gy);
            const Number spread = lower > 0 ? (gx + gy) / lower : Number{1};
            scratch.slope(x, y) = lower;
            scratch.slope_spread(x, y) = spread;
            scratch.exchanged(x, y) = 0;
            const Number r = s.rolling(x, y);
            if (r == 0) continue;

            const Number bend_x = -(west + east), bend_y = -(south + north);
            const auto finer = [&](Number to, Number bend, int step_x, int step_y) {
                return to + kHalf * minmod(bend, bend_beyond(s, x, y, step_x, step_y, to));
            };
            const Number fine_x = greatest(finer(west, bend_x, -1, 0), finer(east, bend_x, 1, 0)) * per_cell;
            const Number fine_y =
                greatest(finer(south, bend_y, 0, -1), finer(north, bend_y, 0, 1)) * per_cell;
            const Number slope = std::sqrt(fine_x * fine_x + fine_y * fine_y);

            const Number stop = params.stop_slope_thick + (params.stop_slope - params.stop_slope_thick) *
                                                              exponential(-r / params.stop_fold_depth);
            const Number steep = std::max(slope - params.erosion_slope, Number{0});
            const Number gentle = std::max(stop - slope, Number{0});

            const Number u = s.velocity_x(x, y), v = s.velocity_y(x, y);
            const Number gate = std::max(Number{0}, 1 - std::sqrt(u * u + v * v) / params.deposit_speed);
            const Number above = std::max(r - params.erosion_depth, Number{0});

            const Number eroded = std::min(pace * std::min(above * above / r, reach) * steep,
                                           std::min(s.depth(x, y), steep * dx / spread));
            const Number laid =
                std::min(pace * gate * std::min(r, reach) * gentle, gentle * dx / kGreatestSpread);
            scratch.exchanged(x, y) = eroded - std::min(laid, r);
        }
}

template void inertial_exchange(const Layers<float>&, const Params&, Scratch<float>&, Substep<float>, int,
                                int);
template void inertial_exchange(const Layers<double>&, const Params&, Scratch<double>&, Substep<double>, int,
                                int);

}  // namespace sim::bcre
