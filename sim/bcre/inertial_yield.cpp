#include <algorithm>

#include "sim/bcre/inertial.h"
#include "sim/layers.h"
#include "sim/params.h"
#include "sim/quanta.h"
#include "sim/scratch.h"

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
            const bool on_top = loose > 0 && loose + before >= params.freeze_depth;
            const Number start_slope = on_top ? std::min<Number>(holds, params.erosion_slope) : holds;
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
