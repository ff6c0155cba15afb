#include <algorithm>
#include <cmath>

#include "sim/bcre/stages.h"
#include "sim/params.h"
#include "sim/scratch.h"
#include "sim/state.h"

// Two thresholds (Daerr & Douady 1999). A vertex whose rolling layer is thinner than R_min is at rest:
//
//     S > s_start   start:   min(d, start_depth) begins to roll
//     S ≤ s_start   freeze:  the thin layer joins the standing one
//
// so a pile between its two thresholds comes to a rest that is exact, and holds no denormals.

namespace sim::bcre {

void yield(State& s, const Params& params, const Scratch& scratch, int first, int last) {
    const float start_depth = std::rint(params.start_depth / kQuantum) * kQuantum;
    for (int y = first; y < last; ++y) {
        const float *slope = scratch.slope.row(y), *start_slope = s.start_slope.row(y);
        float *d = s.depth.row(y), *r = s.rolling.row(y);
        float *u = s.velocity_x.row(y), *v = s.velocity_y.row(y);
        for (int x = 0; x < s.grid.nx; ++x) {
            const float before = r[x];
            if (before >= params.freeze_depth) continue;
            const bool starts = slope[x] > start_slope[x];
            if (!starts && before == 0) continue;
            const float moved = starts ? std::min(d[x], start_depth) : -before;
            d[x] -= moved;
            r[x] += moved;
            const float kept = r[x] > 0 ? before / r[x] : 0.f;  // what starts is at rest
            u[x] *= kept;
            v[x] *= kept;
        }
    }
}

}  // namespace sim::bcre
