#include <algorithm>

#include "sim/bcre/inertial.h"
#include "sim/bcre/inertial_terminal.h"
#include "sim/exponential.h"
#include "sim/layers.h"
#include "sim/params.h"
#include "sim/quanta.h"
#include "sim/scratch.h"

// Heun's method, which is the second-order one of Gottlieb, Shu and Tadmor (2001), between two halves of
// relaxation A (Strang 1968). L is what transport and exchange do in a sub-step:
//
//     u₀ ← A(½Δt) u₀      u₁ = u₀ + L(u₀)      u₂ = u₁ + L(u₁)      u ← A(½Δt) ½ (u₀ + u₂)
//
//              F_n
//               ↑            R ← R − (F_e − F_w) − (F_n − F_s) + X
//      F_w →    C    → F_e   R v likewise with the momentum of each flux
//               ↑            X > 0 starts at rest; X < 0 takes its momentum along: what stays keeps its speed
//              F_s
//
// Mass is booked once, as the mean of both stages' fluxes and exchange, in whole quanta; velocities have
// none, and become the mean by mass, (R₀ v₀ + R₂ v₂) / (R₀ + R₂). The last half of A reckons with the
// terminal velocity on u₁, which is as good there to second order and known already.

namespace sim::bcre {
namespace {

// Of a vertex that gave nearly all it had a residue of rounding is left, and so of its momentum; their
// quotient means nothing and must not grow. Thinner than this a layer is none (m; a quantum is 7.6e-6), and
// no velocity passes this (m/s; no numbers allow half of it).
constexpr float kNothing = 1e-12f, kFastest = 400;

template <class Number>
struct Rolling {
    Number depth, u, v, exchanged;
};

// What rolls at a vertex at the end of a stage, and how much of what it would exchange it can.
template <class Number>
Rolling<Number> after_stage(const Layers<Number>& s, const Scratch<Number>& scratch, int x, int y) {
    const auto leaves = [x, y](const Field<Number>& through_x, const Field<Number>& through_y) {
        return (through_x(x, y) - through_x(x - 1, y)) + (through_y(x, y) - through_y(x, y - 1));
    };
    const Number before = s.rolling(x, y);
    const Number carried = std::max(before - leaves(scratch.flux_x, scratch.flux_y), Number{0});
    const Number exchanged = std::max(scratch.exchanged(x, y), -carried);
    const Number end = carried + exchanged;
    // Divided by all the mass that has this momentum: what came and stayed, or that and what was eroded.
    if (end < kNothing) return {0, 0, 0, exchanged};
    const Number per_depth = 1 / std::max(carried, end);
    const Number momentum_u =
        before * s.velocity_x(x, y) - leaves(scratch.momentum_x.u, scratch.momentum_y.u);
    const Number momentum_v =
        before * s.velocity_y(x, y) - leaves(scratch.momentum_x.v, scratch.momentum_y.v);
    const auto bounded = [](Number speed) { return std::clamp<Number>(speed, -kFastest, kFastest); };
    return {end, bounded(momentum_u * per_depth), bounded(momentum_v * per_depth), exchanged};
}

}  // namespace

template <class Number>
void inertial_predict(const Layers<Number>& s, Scratch<Number>& scratch, int first, int last) {
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            const Rolling<Number> end = after_stage(s, scratch, x, y);
            scratch.exchanged(x, y) = end.exchanged;
            scratch.depth(x, y) = s.depth(x, y) - end.exchanged;
            scratch.rolling(x, y) = end.depth;
            scratch.velocity_x(x, y) = end.u;
            scratch.velocity_y(x, y) = end.v;
        }
}

template <class Number>
void inertial_book(Scratch<Number>& scratch, Substep<Number> sub, int first, int last) {
    const auto book = [&](const Field<Number>& second, Field<Number>& into, int y, int from) {
        const Number* other = second.row(y);
        Number* one = into.row(y);
        for (int x = from; x < second.nx(); ++x)
            one[x] = to_quanta(Number{0.5f} * (one[x] + other[x]), sub.dither);
    };
    for (int y = first == 0 ? -1 : first; y < last; ++y) book(scratch.flux_y, scratch.first_flux_y, y, 0);
    for (int y = first; y < last; ++y) book(scratch.flux_x, scratch.first_flux_x, y, -1);
}

template <class Number>
void inertial_finish(const Layers<Number>& predicted, const Params& params, Scratch<Number>& scratch,
                     Substep<Number> sub, int first, int last) {
    const TerminalVelocity<Number> terminal(predicted, params);
    const Number gained = 1 - exponential(Number{-0.5f} * sub.dt / params.relaxation_time);
    const Field<Number>&fx = scratch.first_flux_x, &fy = scratch.first_flux_y;
    for (int y = first; y < last; ++y)
        for (int x = 0; x < predicted.grid.nx; ++x) {
            Number &d = scratch.depth(x, y), &r = scratch.rolling(x, y);
            Number &u = scratch.velocity_x(x, y), &v = scratch.velocity_y(x, y);
            const Rolling<Number> second = after_stage(predicted, scratch, x, y);

            const Number both = r + second.depth, per_depth = both > 0 ? 1 / both : Number{0};
            const Number mean_u = (r * u + second.depth * second.u) * per_depth;
            const Number mean_v = (r * v + second.depth * second.v) * per_depth;

            const Number carried = r - ((fx(x, y) - fx(x - 1, y)) + (fy(x, y) - fy(x, y - 1)));
            const Number exchanged = Number{0.5f} * (scratch.first_exchanged(x, y) + second.exchanged);
            const Number moved = std::clamp(to_quanta(exchanged, sub.dither), -carried, d);
            d -= moved;
            r = carried + moved;
            CHECK(r >= 0);

            const Velocity<Number> end = terminal.at(x, y);
            u = r > 0 ? mean_u + gained * (end.u - mean_u) : Number{0};
            v = r > 0 ? mean_v + gained * (end.v - mean_v) : Number{0};
        }
}

template void inertial_predict(const Layers<float>&, Scratch<float>&, int, int);
template void inertial_predict(const Layers<double>&, Scratch<double>&, int, int);
template void inertial_book(Scratch<float>&, Substep<float>, int, int);
template void inertial_book(Scratch<double>&, Substep<double>, int, int);
template void inertial_finish(const Layers<float>&, const Params&, Scratch<float>&, Substep<float>, int, int);
template void inertial_finish(const Layers<double>&, const Params&, Scratch<double>&, Substep<double>, int,
                              int);

}  // namespace sim::bcre
