#include <algorithm>
#include <limits>

#include "sim/bcre/stages.h"
#include "sim/params.h"
#include "sim/quanta.h"
#include "sim/scratch.h"
#include "sim/state.h"

// Two thresholds (Daerr & Douady 1999). A vertex whose rolling layer is thinner than R_min and slow is at rest:
//
//     S > s_start and d + R ≥ R_min   start:   min(d, start_depth) begins to roll
//     else                            freeze:  the thin layer joins the standing one
//
// so a pile between its two thresholds comes to a rest that is exact, and holds no denormals. Slow is what deposits: in
// bcre everything, in bcre-inertial what is below the deposit speed; without that a front, which is thin where it arrives,
// would be stopped the more often the shorter the sub-step. Less than R_min in all lies on any slope, as dust does.

namespace sim::bcre {

void yield(State& s, const Params& params, const Scratch& scratch, int first, int last) {
    const float start_depth = nearest_quanta(params.start_depth);
    const float slow = params.model == Model::kBcreInertial ? params.deposit_speed : std::numeric_limits<float>::infinity();
    for (int y = first; y < last; ++y) {
        const float *slope = scratch.slope.row(y), *start_slope = s.start_slope.row(y);
        float *d = s.depth.row(y), *r = s.rolling.row(y);
        float *u = s.velocity_x.row(y), *v = s.velocity_y.row(y);
        for (int x = 0; x < s.grid.nx; ++x) {
            const float before = r[x];
            if (before >= params.freeze_depth) continue;
            const bool starts = slope[x] > start_slope[x] && d[x] + before >= params.freeze_depth;
            if (!starts && (before == 0 || u[x] * u[x] + v[x] * v[x] > slow * slow)) continue;
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
