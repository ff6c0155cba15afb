#include <algorithm>
#include <cmath>

#include "sim/bcre/stages.h"
#include "sim/exponential.h"
#include "sim/layers.h"
#include "sim/params.h"
#include "sim/quanta.h"
#include "sim/scratch.h"

// Exchange between the layers: ∂R/∂t = γ R p, ∂h/∂t = −γ R p, with p = S − threshold and S the slope toward
// the lower neighbours of h (slope.cpp). In a thick flow only the lowest R_c of the layer reaches the ground:
// γ min(R, R_c) p (Boutreux, Raphaël and de Gennes 1998).
//
// With the lower neighbours held for the sub-step, p falls with what is eroded: a logistic equation in R. Its
// solution never takes S past the threshold. A vertex that is raised may come above a neighbour that was not
// lower before, so deposition reckons with the greatest κ, √2. Where p changes little in a sub-step the
// solution is the exponential. In a thick flow R drops out, and p falls exponentially: what is exchanged is
// p (Δx/κ) (1 − e^(−γ R_c κ Δt/Δx)), or γ R_c p Δt where p changes little.

namespace sim::bcre {
namespace {

// κ where the vertex is lowered, and the greatest where it is raised.
template <class Number>
Number spread_of(Number excess, Number spread) {
    constexpr float kGreatest = 1.41421356f;
    return excess < 0 ? kGreatest : spread;
}

// R after a sub-step that began with R₀ > 0, of which no more than `reach` exchanges.
template <class Number>
Number after_exchange(Number rolling, Number excess, Number rate, Number reach, Number spread, Number dx,
                      Number dt) {
    const Number kappa = spread_of(excess, spread);
    const Number growth = rate * excess * dt;
    const bool changes_little = rate * std::min(rolling, reach) * (dt / dx) < 0.2f;
    if (rolling > reach)
        return rolling + (changes_little
                              ? growth * reach
                              : excess * dx / kappa * (1 - exponential(-rate * reach * kappa * (dt / dx))));
    if (changes_little && std::fabs(growth) < 0.5f) return rolling * exponential(growth);
    const Number end = rolling + excess * dx / kappa;  // K: R when S has reached the threshold
    const Number pace = rate * kappa * (dt / dx);
    if (std::fabs(end) * pace < 1e-4f) return rolling / (1.f + pace * rolling);  // the limit K → 0
    return end / (1.f + (end / rolling - 1.f) * exponential(-pace * end));
}

// Moves `amount` from the standing to the rolling layer, or back if negative: whole quanta, no more than
// there is. What is eroded starts at rest; what is deposited takes its momentum along.
template <class Number>
void transfer(Layers<Number>& s, int x, int y, Number amount, float dither) {
    Number &d = s.depth(x, y), &r = s.rolling(x, y);
    const Number moved = std::clamp(to_quanta(amount, dither), -r, d);
    const Number before = r;
    d -= moved;
    r += moved;
    const Number kept = moved > 0 ? before / r : (r > 0 ? 1.f : Number{0});
    s.velocity_x(x, y) *= kept;
    s.velocity_y(x, y) *= kept;
}

}  // namespace

// Exchange with a speed gate on deposition, a threshold that falls with depth, and a band between the stop
// and the erosion slope in which nothing is exchanged.
template <class Number>
void exchange_inertial(Layers<Number>& s, const Params& params, const Scratch<Number>& scratch,
                       Substep<Number> sub, int first, int last) {
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            const Number r = s.rolling(x, y);
            if (r == 0) continue;
            const Number slope = scratch.slope(x, y), spread = scratch.slope_spread(x, y);
            const Number stop = params.stop_slope_thick + (params.stop_slope - params.stop_slope_thick) *
                                                              exponential(-r / params.stop_fold_depth);
            Number excess = 0, rate = params.exchange_rate;
            if (slope < stop) {
                const Number u = s.velocity_x(x, y), v = s.velocity_y(x, y);
                excess = slope - stop;
                rate *= std::max(Number{0}, 1 - std::sqrt(u * u + v * v) / params.deposit_speed);
            } else if (slope > params.erosion_slope && r > params.erosion_depth) {
                excess = slope - params.erosion_slope;
            }
            if (excess != 0)
                transfer(s, x, y,
                         after_exchange(r, excess, rate, Number{params.exchange_depth}, spread,
                                        Number{s.grid.dx}, sub.dt) -
                             r,
                         sub.dither);
        }
}

template void exchange_inertial(Layers<float>&, const Params&, const Scratch<float>&, Substep<float>, int,
                                int);
template void exchange_inertial(Layers<double>&, const Params&, const Scratch<double>&, Substep<double>, int,
                                int);

}  // namespace sim::bcre
