#include <algorithm>
#include <cmath>

#include "sim/bcre/stages.h"
#include "sim/exponential.h"
#include "sim/params.h"
#include "sim/quanta.h"
#include "sim/scratch.h"
#include "sim/state.h"

// Exchange between the layers, thin flow: ∂R/∂t = γ R p, ∂h/∂t = −γ R p, with p = S − threshold and S the
// slope toward the lower neighbours of h (upwind: what lies uphill feels what happens below, and a
// checkerboard is seen):
//
//            N              g_x = max(0, h_C − h_W, h_C − h_E) / Δx
//            |              g_y = max(0, h_C − h_S, h_C − h_N) / Δx
//        W — C — E          S = |g|,  κ = (g_x + g_y) / |g| ∈ [1, √2]
//            |
//            S              lowering C by Δ lowers S by at most κ Δ/Δx
//
// With the lower neighbours held for the sub-step, p falls with what is eroded: a logistic equation in R. Its
// solution never takes S past the threshold. A vertex that is raised may come above a neighbour that was not
// lower before, so deposition reckons with the greatest κ, √2. Where p changes little in a sub-step the
// solution is the exponential.

namespace sim::bcre {
namespace {

// R after a sub-step that began with R₀ > 0.
float after_exchange(float rolling, float excess, float rate, float spread, float dx, float dt) {
    const float growth = rate * excess * dt;
    if (rate * rolling * (dt / dx) < 0.2f && std::fabs(growth) < 0.5f) return rolling * exponential(growth);
    const float kappa = excess < 0 ? 1.41421356f : spread;
    const float end = rolling + excess * dx / kappa;  // K: R when S has reached the threshold
    const float pace = rate * kappa * (dt / dx);
    if (std::fabs(end) * pace < 1e-4f) return rolling / (1.f + pace * rolling);  // the limit K → 0
    return end / (1.f + (end / rolling - 1.f) * exponential(-pace * end));
}

// Moves `amount` from the standing to the rolling layer, or back if negative: whole quanta, no more than
// there is. What is eroded starts at rest; what is deposited takes its momentum along.
void transfer(State& s, int x, int y, float amount, float dither) {
    float &d = s.depth(x, y), &r = s.rolling(x, y);
    const float moved = std::clamp(to_quanta(amount, dither), -r, d);
    const float before = r;
    d -= moved;
    r += moved;
    const float kept = moved > 0 ? before / r : (r > 0 ? 1.f : 0.f);
    s.velocity_x(x, y) *= kept;
    s.velocity_y(x, y) *= kept;
}

}  // namespace

void lower_slope(const State& s, Scratch& scratch, int first, int last) {
    const float per_cell = 1.f / s.grid.dx;
    for (int y = first; y < last; ++y) {
        const float *b = s.bedrock.row(y), *b_n = s.bedrock.row(y + 1), *b_s = s.bedrock.row(y - 1);
        const float *d = s.depth.row(y), *d_n = s.depth.row(y + 1), *d_s = s.depth.row(y - 1);
        float *slope = scratch.slope.row(y), *spread = scratch.slope_spread.row(y);
        for (int x = 0; x < s.grid.nx; ++x) {
            const float west = (b[x] - b[x - 1]) + (d[x] - d[x - 1]),
                        east = (b[x] - b[x + 1]) + (d[x] - d[x + 1]);
            const float south = (b[x] - b_s[x]) + (d[x] - d_s[x]), north = (b[x] - b_n[x]) + (d[x] - d_n[x]);
            const float gx = std::max(0.f, std::max(west, east)) * per_cell;
            const float gy = std::max(0.f, std::max(south, north)) * per_cell;
            slope[x] = std::sqrt(gx * gx + gy * gy);
            spread[x] = slope[x] > 0 ? (gx + gy) / slope[x] : 1.f;
        }
    }
}

void exchange(State& s, const Params& params, const Scratch& scratch, Substep sub, int first, int last) {
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            const float r = s.rolling(x, y);
            if (r == 0) continue;
            const float excess = scratch.slope(x, y) - params.stop_slope;
            transfer(s, x, y,
                     after_exchange(r, excess, params.exchange_rate, scratch.slope_spread(x, y), s.grid.dx,
                                    sub.dt) -
                         r,
                     sub.dither);
        }
}

// The same with a speed gate on deposition, a threshold that falls with depth, and a band between the stop
// and the erosion slope in which nothing is exchanged.
void exchange_inertial(State& s, const Params& params, const Scratch& scratch, Substep sub, int first,
                       int last) {
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            const float r = s.rolling(x, y);
            if (r == 0) continue;
            const float slope = scratch.slope(x, y), spread = scratch.slope_spread(x, y);
            const float stop = params.stop_slope_thick + (params.stop_slope - params.stop_slope_thick) *
                                                             exponential(-r / params.stop_fold_depth);
            float excess = 0, rate = params.exchange_rate;
            if (slope < stop) {
                const float u = s.velocity_x(x, y), v = s.velocity_y(x, y);
                excess = slope - stop;
                rate *= std::max(0.f, 1.f - std::sqrt(u * u + v * v) / params.deposit_speed);
            } else if (slope > params.erosion_slope && r > params.erosion_depth) {
                excess = slope - params.erosion_slope;
            }
            if (excess != 0)
                transfer(s, x, y, after_exchange(r, excess, rate, spread, s.grid.dx, sub.dt) - r, sub.dither);
        }
}

}  // namespace sim::bcre
