#pragma once

#include <cstdint>

#include "sim/inertial/fields.h"
#include "sim/stages/stages.h"

// Heun's method, the second-order method of Gottlieb, Shu and Tadmor (2001), between two halves of relaxation
// A (Strang 1968). L is the change by transport and exchange in a sub-step:
//
//     u₀ ← A(½Δt) u₀      u₁ = u₀ + L(u₀)      u₂ = u₁ + L(u₁)      u ← A(½Δt) ½ (u₀ + u₂)
//
//              F_n
//               ↑            R ← R − (F_e − F_w) − (F_n − F_s) + X
//      F_w →    C    → F_e   R v likewise with the momentum of each flux
//               ↑            X > 0 starts at rest; X < 0 removes its momentum: the remainder keeps its speed
//              F_s
//
// Mass is quantised once, from the mean of both stages' fluxes and exchange. Velocities are not quantised;
// they become the mean weighted by mass, (R₀ v₀ + R₂ v₂) / (R₀ + R₂). The last half of A uses the terminal
// velocity of u₁, which is already known and keeps second order.

namespace sim::inertial {

// The greatest velocity, m/s; no parameters allow half of it. A vertex that lost nearly all its layer keeps
// rounding residues of mass and momentum. Their quotient is meaningless and must not grow.
inline constexpr float kFastest = 400;

// The rolling layer of a vertex at the end of a stage, and its exchange, limited to the available layer.
template <class Number>
struct Rolling {
    Number depth, u, v, exchanged;
};

// A row of a state with the fluxes through its faces.
template <class S>
struct FlowRow {
    const S *rolling, *u, *v, *exchanged;
    const S *flux_x, *flux_south, *flux_north;
    const S *xu, *xv, *yu_south, *yu_north, *yv_south, *yv_north;
};
template <class S>
[[gnu::always_inline]] inline FlowRow<S> flow_row(const StateRows<S>& l, int y) {
    return {l.rolling[y],         l.velocity_x[y],  l.velocity_y[y],     l.exchanged[y],   l.flux_x[y],
            l.flux_y[y],          l.flux_y[y + 1],  l.momentum_xu[y],    l.momentum_xv[y], l.momentum_yu[y],
            l.momentum_yu[y + 1], l.momentum_yv[y], l.momentum_yv[y + 1]};
}

template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Number leaving(const S* in_x, const S* south, const S* north, int i) {
    return (at<Number>(in_x, i + 1) - at<Number>(in_x, i)) + (at<Number>(north, i) - at<Number>(south, i));
}

template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Rolling<Number> after_stage(const FlowRow<S>& row, int i) {
    const Number none(0), before = at<Number>(row.rolling, i);
    const Number carried = max(before - leaving<Number>(row.flux_x, row.flux_south, row.flux_north, i), none);
    const Number exchanged = max(at<Number>(row.exchanged, i), -carried);
    const Number end = carried + exchanged;
    // Divide by all mass with this momentum: the transported layer, and what it eroded.
    const auto rolls = end >= S(kNothing);
    const Number per_depth = Number(1) / select(rolls, max(carried, end), Number(1));
    const auto speed = [&](const S* of, const S* in_x, const S* south, const S* north) {
        const Number momentum = before * at<Number>(of, i) - leaving<Number>(in_x, south, north, i);
        const Number bounded = min(max(momentum * per_depth, Number(S(-kFastest))), Number(S(kFastest)));
        return select(rolls, bounded, none);
    };
    return {select(rolls, end, none), speed(row.u, row.xu, row.yu_south, row.yu_north),
            speed(row.v, row.xv, row.yv_south, row.yv_north), exchanged};
}

// Predicts the state u1 from the rates of u0, unrounded; u1 serves only to find rates. Rows y = 0 … ny-1.
// Reads all of u0; writes its exchanged, limited to the layer after transport, and the layers of u1.
template <class Number, class S = Scalar<Number>>
auto predict(const StageRows<S>& w, StateRows<S>& u0, StateRows<S>& u1, int y) {
    return
        [row = flow_row(w.u0, y), exchanged = u0.exchanged[y], depth = w.u0.depth[y], to_depth = u1.depth[y],
         to_rolling = u1.rolling[y], to_u = u1.velocity_x[y], to_v = u1.velocity_y[y]](int i) {
            const Rolling<Number> end = after_stage<Number>(row, i);
            store(end.exchanged, exchanged + i);
            store<Number>(at<Number>(depth, i) - end.exchanged, to_depth + i);
            store(end.depth, to_rolling + i), store(end.u, to_u + i), store(end.v, to_v + i);
        };
}

// Rounds the mean fluxes of both states to whole quanta, so that both sides of a face transfer the same
// amount. Faces y = 0 … ny. Reads flux_x, flux_y of both; writes those of u0.
template <class Number, class S = Scalar<Number>>
auto quantise_fluxes(const StageRows<S>& w, StateRows<S>& u0, int y) {
    return [c = w.c, one_x = u0.flux_x[y], one_y = u0.flux_y[y], other_x = w.u1.flux_x[y],
            other_y = w.u1.flux_y[y]](int i) {
        const auto book = [&](S* one, const S* other) {
            const Number mean = S(0.5) * (at<Number>(one, i) + at<Number>(other, i));
            store(with_its_sign(mean, [&](const Number& size) { return in_quanta(size, c.dither); }),
                  one + i);
        };
        book(one_x, other_x), book(one_y, other_y);
    };
}

// Sets the layers of u0 to the mean of u₀ and u₂: rows y = 0 … ny-1. Reads all of both states; writes the
// layers of u0, up to vertex `end`. `active`, if given, has one byte per vector of lanes, which is set if
// anything rolled.
template <class Number, class S = Scalar<Number>>
auto finish(const StageRows<S>& w, StateRows<S>& u0, int y, int end, std::uint8_t* active = nullptr) {
    return [c = w.c, second = flow_row(w.u1, y), flux_x = w.u0.flux_x[y], flux_south = w.u0.flux_y[y],
            flux_north = w.u0.flux_y[y + 1], first_exchanged = u0.exchanged[y], depth = u0.depth[y],
            rolling = u0.rolling[y], to_u = u0.velocity_x[y], to_v = u0.velocity_y[y], end, active](int i) {
        const Number none(0), d = at<Number>(depth, i), r = at<Number>(rolling, i);
        const Rolling<Number> led = after_stage<Number>(second, i);
        const Number both = r + led.depth;
        const Number per_depth = Number(1) / max(both, Number(S(kNothing)));
        const Number mean_u = (r * at<Number>(to_u, i) + led.depth * led.u) * per_depth;
        const Number mean_v = (r * at<Number>(to_v, i) + led.depth * led.v) * per_depth;

        const Number carried = r - leaving<Number>(flux_x, flux_south, flux_north, i);
        const Number exchanged = S(0.5) * (at<Number>(first_exchanged, i) + led.exchanged);
        const Number whole =
            with_its_sign(exchanged, [&](const Number& size) { return in_quanta(size, c.dither); });
        const Number moved = min(max(whole, -carried), d);
        const Number rolls = carried + moved;

        const auto moves = rolls > S{0};
        if (active && any_before(end - i, r > S{0} || carried > S{0}))
            active[static_cast<unsigned>(i) / kLanes<Number>] = 1;
        store_before<Number>(end, d - moved, depth, i);
        store_before(end, rolls, rolling, i);
        store_before<Number>(end, select(moves, mean_u, none), to_u, i);
        store_before<Number>(end, select(moves, mean_v, none), to_v, i);
    };
}

}  // namespace sim::inertial
