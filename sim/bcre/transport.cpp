#include <algorithm>

#include "sim/bcre/stages.h"
#include "sim/quanta.h"
#include "sim/scratch.h"
#include "sim/state.h"

// From wanted fluxes to layers carried, with nothing lost:
//
//              F_n
//               ↑            R ← R − (F_e − F_w) − (F_n − F_s)
//      F_w →    C    → F_e
//               ↑            what stays keeps its velocity, what comes brings its own:
//              F_s           v ← (R_stays v + Σ F_in v_donor) / (R_stays + Σ F_in)
//
// A flux of both signs leaves its donor: the left vertex if positive, the right one if negative. As a mean
// with positive weights the new velocity never exceeds those it is made of.

namespace sim::bcre {
namespace {

float out_of(float toward, float away) {
    return std::max(toward, 0.f) + std::max(-away, 0.f);
}

}  // namespace

void limit_outflow(const State& s, Scratch& scratch, int first, int last) {
    // Rounding a face's flux may add a quantum; with four faces a vertex keeps four in hand.
    constexpr float kInHand = 4 * kQuantum;
    for (int y = first; y < last; ++y) {
        const float* r = s.rolling.row(y);
        const float *fx = scratch.flux_x.row(y), *fn = scratch.flux_y.row(y), *fs = scratch.flux_y.row(y - 1);
        float* scale = scratch.outflow_scale.row(y);
        for (int x = 0; x < s.grid.nx; ++x) {
            const float wanted = out_of(fx[x], fx[x - 1]) + out_of(fn[x], fs[x]);
            // A millionth less, for the rounding of the products that follow.
            const float had = std::max(r[x] - kInHand, 0.f) * (1.f - 1e-6f);
            scale[x] = wanted > had ? had / wanted : 1.f;
        }
    }
}

void round_fluxes(const State& s, Scratch& scratch, Substep sub, int first, int last) {
    const auto rounded = [=](float flux, float left_scale, float right_scale) {
        return to_quanta(flux * (flux > 0 ? left_scale : right_scale), sub.dither);
    };
    for (int y = first; y < last; ++y) {
        const float* scale = scratch.outflow_scale.row(y);
        float* flux = scratch.flux_x.row(y);
        for (int x = -1; x < s.grid.nx; ++x) flux[x] = rounded(flux[x], scale[x], scale[x + 1]);
    }
    for (int y = first == 0 ? -1 : first; y < last; ++y) {
        const float *left = scratch.outflow_scale.row(y), *right = scratch.outflow_scale.row(y + 1);
        float* flux = scratch.flux_y.row(y);
        for (int x = 0; x < s.grid.nx; ++x) flux[x] = rounded(flux[x], left[x], right[x]);
    }
}

void carry(const State& s, Scratch& scratch, int first, int last) {
    for (int y = first; y < last; ++y) {
        const float* r = s.rolling.row(y);
        const float *fx = scratch.flux_x.row(y), *fn = scratch.flux_y.row(y), *fs = scratch.flux_y.row(y - 1);
        const float *u = s.velocity_x.row(y), *u_n = s.velocity_x.row(y + 1), *u_s = s.velocity_x.row(y - 1);
        const float *v = s.velocity_y.row(y), *v_n = s.velocity_y.row(y + 1), *v_s = s.velocity_y.row(y - 1);
        float *rolling = scratch.rolling.row(y), *new_u = scratch.velocity_x.row(y),
              *new_v = scratch.velocity_y.row(y);
        for (int x = 0; x < s.grid.nx; ++x) {
            const float west = std::max(fx[x - 1], 0.f), east = std::max(-fx[x], 0.f);
            const float south = std::max(fs[x], 0.f), north = std::max(-fn[x], 0.f);
            const float stays = r[x] - (out_of(fx[x], fx[x - 1]) + out_of(fn[x], fs[x]));
            CHECK(stays >= 0);
            const float after = stays + ((west + east) + (south + north));
            const float per_depth = after > 0 ? 1.f / after : 0.f;
            rolling[x] = after;
            new_u[x] =
                (stays * u[x] + ((west * u[x - 1] + east * u[x + 1]) + (south * u_s[x] + north * u_n[x]))) *
                per_depth;
            new_v[x] =
                (stays * v[x] + ((west * v[x - 1] + east * v[x + 1]) + (south * v_s[x] + north * v_n[x]))) *
                per_depth;
        }
    }
}

}  // namespace sim::bcre
