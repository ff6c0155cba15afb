#include <algorithm>
#include <cmath>

#include "sim/bcre/minmod.h"
#include "sim/bcre/stages.h"
#include "sim/layers.h"
#include "sim/scratch.h"

// Slope toward the lower neighbours of h, upwind: what lies uphill feels what happens below, and a
// checkerboard is seen.
//
//            N              g_x = max(0, D_W, D_E) / Δx
//            |              g_y = max(0, D_S, D_N) / Δx
//   WW — W — C — E — EE     S = |g|,  κ = (g_x + g_y) / |g| ∈ [1, √2]
//            |              D_W = h_C − h_W  [+ ½ minmod(h_E − 2 h_C + h_W, h_C − 2 h_W + h_WW)]
//            S              lowering C by Δ lowers S by at most κ Δ/Δx
//
// The term in brackets makes it second order where h is smooth (Osher and Shu 1991). Bedrock and depth are
// differenced apart: their sum would lose the layers' last digits. Beyond the halo nothing is known, and the
// term is left out.

namespace sim::bcre {
namespace {

template <class Number>
void store(Number west, Number east, Number south, Number north, Number per_cell, Number& slope,
           Number& spread) {
    const Number gx = std::max(Number{0}, std::max(west, east)) * per_cell;
    const Number gy = std::max(Number{0}, std::max(south, north)) * per_cell;
    slope = std::sqrt(gx * gx + gy * gy);
    spread = slope > 0 ? (gx + gy) / slope : Number{1};
}

}  // namespace

template <class Number>
void lower_slope(const Layers<Number>& s, Scratch<Number>& scratch, int first, int last) {
    const Number per_cell = 1 / Number{s.grid.dx};
    for (int y = first; y < last; ++y) {
        const Number *b = s.bedrock.row(y), *b_n = s.bedrock.row(y + 1), *b_s = s.bedrock.row(y - 1);
        const Number *d = s.depth.row(y), *d_n = s.depth.row(y + 1), *d_s = s.depth.row(y - 1);
        Number *slope = scratch.slope.row(y), *spread = scratch.slope_spread.row(y);
        for (int x = 0; x < s.grid.nx; ++x)
            store((b[x] - b[x - 1]) + (d[x] - d[x - 1]), (b[x] - b[x + 1]) + (d[x] - d[x + 1]),
                  (b[x] - b_s[x]) + (d[x] - d_s[x]), (b[x] - b_n[x]) + (d[x] - d_n[x]), per_cell, slope[x],
                  spread[x]);
    }
}

template void lower_slope(const Layers<float>&, Scratch<float>&, int, int);
template void lower_slope(const Layers<double>&, Scratch<double>&, int, int);

}  // namespace sim::bcre
