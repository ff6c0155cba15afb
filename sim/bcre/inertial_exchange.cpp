#include <algorithm>
#include <cmath>

#include "sim/bcre/drops.h"
#include "sim/bcre/inertial.h"
#include "sim/exponential.h"
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

template <class Number>
void inertial_exchange(const Layers<Number>& s, const Params& params, Scratch<Number>& scratch,
                       Substep<Number> sub, int first, int last) {
    constexpr Number kGreatestSpread = 1.41421356f;
    const Number dx = s.grid.dx, per_cell = 1 / dx, pace = params.exchange_rate * sub.dt;
    const Number reach = params.exchange_depth;
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            const Toward<Number> drop = drops(s, x, y), down = downward(drop);
            const Number gx = std::max(down.west, down.east) * per_cell;
            const Number gy = std::max(down.south, down.north) * per_cell;
            const Number lower = std::sqrt(gx * gx + gy * gy);
            const Number spread = lower > 0 ? (gx + gy) / lower : Number{1};
            scratch.slope(x, y) = lower;
            scratch.slope_spread(x, y) = spread;
            scratch.exchanged(x, y) = 0;
            const Number r = s.rolling(x, y);
            if (r == 0) continue;

            const Toward<Number> fine = downward(limited_drops(s, drop, x, y));
            const Number fine_x = std::max(fine.west, fine.east) * per_cell;
            const Number fine_y = std::max(fine.south, fine.north) * per_cell;
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
