#include <algorithm>

#include "sim/bcre/inertial.h"
#include "sim/layers.h"
#include "sim/params.h"
#include "sim/quanta.h"
#include "sim/scratch.h"

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

namespace sim::bcre {
namespace {

constexpr float kStandsStill = 1e-3f;  // m/s; a grain on a slope is faster after its first sub-step

}  // namespace

template <class Number>
void inertial_yield(Layers<Number>& s, const Params& params, const Scratch<Number>& scratch, int first,
                    int last) {
    const Number per_cell = 1 / Number{s.grid.dx};
    const Number start_depth = nearest_quanta(Number{params.start_depth});
    const Number slow = params.deposit_speed;
    const Number margin = params.anchor_margin + params.anchor_step * per_cell;
    for (int y = first; y < last; ++y) {
        const Number *slope = scratch.slope.row(y), *spread = scratch.slope_spread.row(y);
        const Number *first_slope = s.first_slope.row(y), *first_depth = s.first_depth.row(y);
        Number *d = s.depth.row(y), *r = s.rolling.row(y);
        Number *u = s.velocity_x.row(y), *v = s.velocity_y.row(y);
        for (int x = 0; x < s.grid.nx; ++x) {
            const Number before = r[x], loose = d[x] - first_depth[x];
            const Number holds =
                std::max<Number>(params.start_slope, params.anchor_gain * first_slope[x] + margin);
            const bool lies_loose = loose > 0 && loose + before >= params.freeze_depth;
            const Number start_slope = lies_loose ? std::min<Number>(holds, params.erosion_slope) : holds;
            const Number speed_squared = u[x] * u[x] + v[x] * v[x];
            const bool thin = before < params.freeze_depth;
            const bool stands = speed_squared < kStandsStill * kStandsStill &&
                                slope[x] + spread[x] * before * per_cell <= start_slope;
            if (!thin && !stands) continue;
            const bool starts = slope[x] > start_slope && d[x] + before >= params.freeze_depth;
            if (!starts && (before == 0 || speed_squared > slow * slow)) continue;
            const Number can_start = slope[x] > holds ? d[x] : loose;
            const Number moved = starts ? std::min(can_start, start_depth) : -before;
            d[x] -= moved;
            r[x] += moved;
            const Number kept = r[x] > 0 ? before / r[x] : Number{0};  // what starts is at rest
            u[x] *= kept;
            v[x] *= kept;
        }
    }
}

template void inertial_yield(Layers<float>&, const Params&, const Scratch<float>&, int, int);
template void inertial_yield(Layers<double>&, const Params&, const Scratch<double>&, int, int);

}  // namespace sim::bcre
