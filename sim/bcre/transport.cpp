#include <algorithm>

#include "sim/bcre/stages.h"
#include "sim/layers.h"
#include "sim/quanta.h"
#include "sim/scratch.h"

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

template <class Number>
Number out_of(Number toward, Number away) {
    return std::max(toward, Number{0}) + std::max(-away, Number{0});
}

}  // namespace

template <class Number>
void limit_outflow(const Layers<Number>& s, Scratch<Number>& scratch, int first, int last) {
    // Rounding a face's flux may add a quantum; with four faces a vertex keeps four in hand.
    constexpr Number kInHand = 4 * kGrain<Number>;
    for (int y = first; y < last; ++y) {
        const Number* r = s.rolling.row(y);
        const Number *fx = scratch.flux_x.row(y), *fn = scratch.flux_y.row(y),
                     *fs = scratch.flux_y.row(y - 1);
        Number* scale = scratch.outflow_scale.row(y);
        for (int x = 0; x < s.grid.nx; ++x) {
            const Number wanted = out_of(fx[x], fx[x - 1]) + out_of(fn[x], fs[x]);
            // A millionth less, for the rounding of the products that follow.
            const Number had = std::max(r[x] - kInHand, Number{0}) * (1.f - 1e-6f);
            scale[x] = wanted > had ? had / wanted : 1.f;
        }
    }
}

template <class Number>
void round_fluxes(const Layers<Number>& s, Scratch<Number>& scratch, Substep<Number> sub, int first,
                  int last) {
    const auto rounded = [=](Number flux, Number left_scale, Number right_scale) {
        return to_quanta(flux * (flux > 0 ? left_scale : right_scale), sub.dither);
    };
    for (int y = first; y < last; ++y) {
        const Number* scale = scratch.outflow_scale.row(y);
        Number* flux = scratch.flux_x.row(y);
        for (int x = -1; x < s.grid.nx; ++x) flux[x] = rounded(flux[x], scale[x], scale[x + 1]);
    }
    for (int y = first == 0 ? -1 : first; y < last; ++y) {
        const Number *left = scratch.outflow_scale.row(y), *right = scratch.outflow_scale.row(y + 1);
        Number* flux = scratch.flux_y.row(y);
        for (int x = 0; x < s.grid.nx; ++x) flux[x] = rounded(flux[x], left[x], right[x]);
    }
}

template <class Number>
void carry(const Layers<Number>& s, Scratch<Number>& scratch, int first, int last) {
    for (int y = first; y < last; ++y) {
        const Number* r = s.rolling.row(y);
        const Number *fx = scratch.flux_x.row(y), *fn = scratch.flux_y.row(y),
                     *fs = scratch.flux_y.row(y - 1);
        const Number *u = s.velocity_x.row(y), *u_n = s.velocity_x.row(y + 1), *u_s = s.velocity_x.row(y - 1);
        const Number *v = s.velocity_y.row(y), *v_n = s.velocity_y.row(y + 1), *v_s = s.velocity_y.row(y - 1);
        Number *rolling = scratch.rolling.row(y), *new_u = scratch.velocity_x.row(y),
               *new_v = scratch.velocity_y.row(y);
        for (int x = 0; x < s.grid.nx; ++x) {
            const Number west = std::max(fx[x - 1], Number{0}), east = std::max(-fx[x], Number{0});
            const Number south = std::max(fs[x], Number{0}), north = std::max(-fn[x], Number{0});
            const Number stays = r[x] - (out_of(fx[x], fx[x - 1]) + out_of(fn[x], fs[x]));
            CHECK(stays >= 0);
            const Number after = stays + ((west + east) + (south + north));
            const Number per_depth = after > 0 ? 1.f / after : Number{0};
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

template void limit_outflow(const Layers<float>&, Scratch<float>&, int, int);
template void limit_outflow(const Layers<double>&, Scratch<double>&, int, int);
template void round_fluxes(const Layers<float>&, Scratch<float>&, Substep<float>, int, int);
template void round_fluxes(const Layers<double>&, Scratch<double>&, Substep<double>, int, int);
template void carry(const Layers<float>&, Scratch<float>&, int, int);
template void carry(const Layers<double>&, Scratch<double>&, int, int);

}  // namespace sim::bcre
