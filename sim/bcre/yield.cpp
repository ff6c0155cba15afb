#include <algorithm>
#include <limits>

#include "sim/bcre/stages.h"
#include "sim/params.h"
#include "sim/quanta.h"
#include "sim/scratch.h"
#include "sim/state.h"

// Two thresholds (Daerr & Douady 1999). A vertex whose rolling layer is thinner than R_min and slow is at
// rest:
//
//     S > s_start and d + R ≥ R_min   start:   min(d, start_depth) begins to roll
//     else                            freeze:  the thin layer joins the standing one
//
// so a pile between its two thresholds comes to a rest that is exact, and holds no denormals. Slow is what
// deposits: in bcre everything, in bcre-inertial what is below the deposit speed; without that a front, which
// is thin where it arrives, would be stopped the more often the shorter the sub-step. Less than R_min in all
// lies on any slope, as dust does.
//
// Natural ground holds: in bcre-inertial a vertex that was steep from the first starts only when it has
// become steeper yet, s_start = max(start_slope, anchor_gain S₀ + anchor_margin).
//
// A layer of any depth that stands still, as on the very top of a heap, where no side is down, freezes too if
// the vertex holds when it has: S + κ R/Δx ≤ s_start.

namespace sim::bcre {
namespace {

constexpr float kStandsStill = 1e-3f;  // m/s; a grain on a slope is faster after its first sub-step

}  // namespace

void yield(State& s, const Params& params, const Scratch& scratch, int first, int last) {
    const float per_cell = 1.f / s.grid.dx;
    const float start_depth = nearest_quanta(params.start_depth);
    const bool inertial = params.model == Model::kBcreInertial;
    const float slow = inertial ? params.deposit_speed : std::numeric_limits<float>::infinity();
    const float gain = inertial ? params.anchor_gain : 0.f, margin = inertial ? params.anchor_margin : 0.f;
    for (int y = first; y < last; ++y) {
        const float *slope = scratch.slope.row(y), *spread = scratch.slope_spread.row(y);
        const float* first_slope = s.first_slope.row(y);
        float *d = s.depth.row(y), *r = s.rolling.row(y);
        float *u = s.velocity_x.row(y), *v = s.velocity_y.row(y);
        for (int x = 0; x < s.grid.nx; ++x) {
            const float before = r[x];
            const float start_slope = std::max(params.start_slope, gain * first_slope[x] + margin);
            const float speed_squared = u[x] * u[x] + v[x] * v[x];
            const bool thin = before < params.freeze_depth;
            const bool stands = speed_squared < kStandsStill * kStandsStill &&
                                slope[x] + spread[x] * before * per_cell <= start_slope;
            if (!thin && !stands) continue;
            const bool starts = slope[x] > start_slope && d[x] + before >= params.freeze_depth;
            if (!starts && (before == 0 || speed_squared > slow * slow)) continue;
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
