#pragma once

#include "sim/momentum/fields.h"
#include "sim/momentum/transport.h"

// The layers after the fluxes of a sub-step:
//
//              F_n
//               ↑            R ← R − (F_e − F_w) − (F_n − F_s)
//      F_w →    C    → F_e   R v: a flux out takes its velocity along, a flux in brings the turned one
//               ↑
//              F_s

namespace sim::momentum {

// Rows y = 0 … ny-1. Reads fed, driven velocity, fluxes and their velocities; writes R and velocity after transport,
// up to vertex `end`. Speeds above greatest_speed are cut; `limited`, if given, counts them. `active`, if given,
// has one byte per vector of lanes, which is set if anything moves, came to rest or passed.
template <class Number, class S = Scalar<Number>>
auto finish(const StageRows<S>& w, Fields<Rows<S>>& to, int y, int end, std::int64_t* limited = nullptr,
            std::uint8_t* active = nullptr) {
    struct Through {
        const S *flux, *leaving_u, *leaving_v, *turned_u, *turned_v;
        // The flux out of a vertex, `out` times that of the face, with its momentum.
        [[gnu::always_inline]] void take(int i, S out, Number& depth, Number& of_u, Number& of_v) const {
            depth = at<Number>(flux, i) * out;
            const auto leaves = depth > S{0};
            of_u = depth * select(leaves, at<Number>(leaving_u, i), at<Number>(turned_u, i));
            of_v = depth * select(leaves, at<Number>(leaving_v, i), at<Number>(turned_v, i));
        }
    };
    const Through x{w.flux_x[y], w.leaving_xu[y], w.leaving_xv[y], w.turned_xu[y], w.turned_xv[y]};
    const auto of_y = [&w](int row) {
        return Through{w.flux_y[row], w.leaving_yu[row], w.leaving_yv[row], w.turned_yu[row],
                       w.turned_yv[row]};
    };
    return [x, south = of_y(y), north = of_y(y + 1), driven_u = w.driven_u[y], driven_v = w.driven_v[y],
            rolling = w.fed[y], to_rolling = to.moved_rolling[y], to_u = to.moved_u[y], to_v = to.moved_v[y],
            most = w.c.greatest_speed, end, limited, active](int i) {
        const Number none(0), r = at<Number>(rolling, i);
        Number e, e_u, e_v, west, west_u, west_v, n, n_u, n_v, s, s_u, s_v;
        x.take(i + 1, S(1), e, e_u, e_v), x.take(i, S(-1), west, west_u, west_v);
        north.take(i, S(1), n, n_u, n_v), south.take(i, S(-1), s, s_u, s_v);
        const Number rolls = r - ((e + west) + (n + s));
        const Number had_u = at<Number>(to_u, i), had_v = at<Number>(to_v, i);
        if (!any(max(r, rolls) > S{0})) {
            if (to_rolling == rolling) return;  // as it is already
            store_before(end, none, to_rolling, i);
            store_before(end, none, to_u, i), store_before(end, none, to_v, i);
            return;
        }

        const auto moves = rolls > kThin<Number>;
        const Number per_depth = Number(1) / select(moves, rolls, Number(1));
        Number u = (r * at<Number>(driven_u, i) - ((e_u + west_u) + (n_u + s_u))) * per_depth;
        Number v = (r * at<Number>(driven_v, i) - ((e_v + west_v) + (n_v + s_v))) * per_depth;
        u = select(moves, u, none) + S{0}, v = select(moves, v, none) + S{0};  // -0 becomes 0
        const Number squared = u * u + v * v;
        const auto fast = squared > most * most;
        if (any_before(end - i, fast)) {
            const Number scale = most / sqrt(select(fast, squared, Number(most * most)));
            u *= scale, v *= scale;
            if (limited) *limited += count_before(end - i, fast);
        }
        const Number change = abs(rolls - r) + ((abs(had_u) + abs(had_v)) + (abs(u) + abs(v)));
        if (active && any_before(end - i, change > S{0}))
            active[static_cast<unsigned>(i) / kLanes<Number>] = 1;
        store_before(end, rolls, to_rolling, i);
        store_before(end, u, to_u, i);
        store_before(end, v, to_v, i);
    };
}

// A wall takes the momentum toward it, at the speed at which a layer that fills up passes it back: v is divided by
// 1 + (v + √(g R)) Δt/Δx. Otherwise gravity would speed up a layer that cannot fall. Rows y = 0 … ny-1.
template <class Number, class S = Scalar<Number>>
void end_finish(const StageRows<S>& w, Fields<Rows<S>>& to, int y, Span x) {
    const S* rolling = w.moved_rolling[y];
    S *u = to.moved_u[y], *v = to.moved_v[y];
    const auto take = [&](Side side, S sign, S* velocity, int i) {
        const S toward = sign * velocity[i];
        if (w.is_wall(side) && toward > S{0})
            velocity[i] /= S{1} + (toward + sqrt(S(kGravity) * rolling[i])) * w.c.courant;
    };
    if (x.first == 0) take(kWest, S{-1}, u, 0);
    if (x.last == w.nx) take(kEast, S{1}, u, w.nx - 1);
    for (int i = x.first; y == 0 && i < x.last; ++i) take(kSouth, S{-1}, v, i);
    for (int i = x.first; y == w.ny - 1 && i < x.last; ++i) take(kNorth, S{1}, v, i);
}

}  // namespace sim::momentum
