#include <algorithm>

#include "sim/bcre/stages.h"
#include "sim/layers.h"
#include "sim/params.h"
#include "sim/quanta.h"
#include "sim/scratch.h"

// Two thresholds (Daerr & Douady 1999). A vertex whose rolling layer is thinner than R_min is at rest:
//
//     S > s_start and d + R ≥ R_min   start:   min(d, start_depth) begins to roll
//     else                            freeze:  the thin layer joins the standing one
//
// so a pile between its two thresholds comes to a rest that is exact, and holds no denormals. Less than R_min
// in all lies on any slope, as dust does.
//
// A layer of any depth that stands still, as on the very top of a heap, where no side is down, freezes too if
// the vertex holds when it has: S + κ R/Δx ≤ s_start.

namespace sim::bcre {
namespace {

constexpr float kStandsStill = 1e-3f;  // m/s; a grain on a slope is faster after its first sub-step

}  // namespace

template <class Number>
void yield(Layers<Number>& s, const Params& params, const Scratch<Number>& scratch, int first, int last) {
    const Number per_cell = 1 / Number{s.grid.dx};
    const Number start_depth = nearest_quanta(Number{params.start_depth});
    const Number start_slope = params.start_slope;
    for (int y = first; y < last; ++y) {
        const Number *slope = scratch.slope.row(y), *spread = scratch.slope_spread.row(y);
        Number *d = s.depth.row(y), *r = s.rolling.row(y);
        Number *u = s.velocity_x.row(y), *v = s.velocity_y.row(y);
        for (int x = 0; x < s.grid.nx; ++x) {
            const Number before = r[x];
            const Number speed_squared = u[x] * u[x] + v[x] * v[x];
            const bool thin = before < params.freeze_depth;
            const bool stands = speed_squared < kStandsStill * kStandsStill &&
                                slope[x] + spread[x] * before * per_cell <= start_slope;
            if (!thin && !stands) continue;
            const bool starts = slope[x] > start_slope && d[x] + before >= params.freeze_depth;
            if (!starts && before == 0) continue;
            const Number moved = starts ? std::min(d[x], start_depth) : -before;
            d[x] -= moved;
            r[x] += moved;
            const Number kept = r[x] > 0 ? before / r[x] : Number{0};  // what starts is at rest
            u[x] *= kept;
            v[x] *= kept;
        }
    }
}

template void yield(Layers<float>&, const Params&, const Scratch<float>&, int, int);
template void yield(Layers<double>&, const Params&, const Scratch<double>&, int, int);

}  // namespace sim::bcre
