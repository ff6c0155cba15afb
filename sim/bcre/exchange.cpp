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
//
// For the schemes of second order the rate itself is wanted, γ min(R, R_c) p Δt; it is held to what would
// take S to the threshold, p Δx/κ, where the cells are too coarse for it.

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

template <class Number>
void exchange(Layers<Number>& s, const Params& params, const Scratch<Number>& scratch, Substep<Number> sub,
              int first, int last) {
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            const Number r = s.rolling(x, y);
            if (r == 0) continue;
            const Number excess = scratch.slope(x, y) - params.stop_slope;
            transfer(s, x, y,
                     after_exchange(r, excess, Number{params.exchange_rate}, Number{params.exchange_depth},
                                    scratch.slope_spread(x, y), Number{s.grid.dx}, sub.dt) -
                         r,
                     sub.dither);
        }
}

template <class Number>
void exchange_at_rate(const Layers<Number>& s, const Params& params, Scratch<Number>& scratch,
                      Substep<Number> sub, int first, int last) {
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            const Number r = s.rolling(x, y), excess = scratch.slope(x, y) - params.stop_slope;
            const Number reach = std::min(r, Number{params.exchange_depth});
            const Number kappa = spread_of(excess, scratch.slope_spread(x, y));
            const Number most = std::fabs(excess) * s.grid.dx / kappa;
            const Number wanted = params.exchange_rate * reach * excess * sub.dt;
            scratch.exchanged(x, y) = std::clamp(wanted, -std::min(most, r), std::min(most, s.depth(x, y)));
        }
}

template <class Number>
void exchange_booked(Layers<Number>& s, const Scratch<Number>& scratch, Substep<Number> sub, int first,
                     int last) {
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x)
            if (scratch.exchanged(x, y) != 0) transfer(s, x, y, scratch.exchanged(x, y), sub.dither);
}

template void exchange(Layers<float>&, const Params&, const Scratch<float>&, Substep<float>, int, int);
template void exchange(Layers<double>&, const Params&, const Scratch<double>&, Substep<double>, int, int);
template void exchange_at_rate(const Layers<float>&, const Params&, Scratch<float>&, Substep<float>, int,
                               int);
template void exchange_at_rate(const Layers<double>&, const Params&, Scratch<double>&, Substep<double>, int,
                               int);
template void exchange_booked(Layers<float>&, const Scratch<float>&, Substep<float>, int, int);
template void exchange_booked(Layers<double>&, const Scratch<double>&, Substep<double>, int, int);

}  // namespace sim::bcre
