#pragma once

#include "sim/inertial/fields.h"
#include "sim/stages/stages.h"

// The terminal velocity of a layer on the current surface, by central differences over the four neighbours of
// the vertex:
//
//            N              g_x = (E − W) / 2Δx
//            |              g_y = (N − S) / 2Δx          of z = h + R
//        W — C — E
//            |              v_eq = −(g/|g|) min(v_max, k_v |g|) R / (R + R_h)
//            S
//
// It uses the slope of z rather than h, because z includes the lateral pressure. Without it a flow would
// erode rills along the grid. Bedrock and layers are differenced separately, because their sum would lose the
// last digits of the layers.
//
// Relaxation: v += (1 − e^(−Δt/2τ)) (v_eq − v) for half a sub-step. It does not change b, d and R, so v_eq is
// constant and the exponential is the exact solution, however short τ. One half before transport and exchange
// and one half after (heun.h) make the sub-step second order (Strang 1968).

namespace sim::inertial {

template <class Number>
struct Velocity {
    Number u, v;  // m/s
};

// The parts of z on a row. rise() is z at vertex j of `to` minus z at vertex i of `from`, m.
template <class S>
struct SurfaceRow {
    const S *bedrock, *depth, *rolling;
};
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Number rise(const SurfaceRow<S>& from, int i, const SurfaceRow<S>& to, int j) {
    return (at<Number>(to.bedrock, j) - at<Number>(from.bedrock, i)) +
           ((at<Number>(to.depth, j) + at<Number>(to.rolling, j)) -
            (at<Number>(from.depth, i) + at<Number>(from.rolling, i)));
}

// The terminal velocity of vertex i of row `here`.
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Velocity<Number> terminal(const SurfaceRow<S>& south, const SurfaceRow<S>& here,
                                                        const SurfaceRow<S>& north, int i,
                                                        const Constants<S>& c) {
    const S per_step = S(0.5) * c.per_cell;
    const Number gx = rise<Number>(here, i - 1, here, i + 1) * per_step;
    const Number gy = rise<Number>(south, i, north, i) * per_step;
    const Number squared = gx * gx + gy * gy, r = at<Number>(here.rolling, i);
    Number per_slope(c.speed_per_slope);
    if (any(squared > c.nearly_capped_squared)) {
        const Number steepness = sqrt(squared);
        const auto fastest = steepness * c.speed_per_slope > c.max_speed;
        per_slope = select(fastest, c.max_speed / select(fastest, steepness, Number(1)), per_slope);
    }
    const Number along = -per_slope * (r / max(r + c.half_speed_depth, Number(S(kNothing))));
    return {along * gx, along * gy};
}

template <class S>
[[gnu::always_inline]] inline SurfaceRow<S> surface_row(const StageRows<S>& w, const StateRows<S>& level,
                                                        int y) {
    return {w.bedrock[y], level.depth[y], level.rolling[y]};
}

// Half of a sub-step's relaxation, toward the terminal velocity of a state: rows y = 0 … ny-1. Reads b, d and
// R of that state, and R of u0; writes velocity of u0, up to vertex `end`.
template <class Number, class S = Scalar<Number>>
auto relax(const StageRows<S>& w, const StateRows<S>& toward, StateRows<S>& out, int y, int end) {
    return [c = w.c, south = surface_row(w, toward, y - 1), here = surface_row(w, toward, y),
            north = surface_row(w, toward, y + 1), rolling = w.u0.rolling[y], to_u = out.velocity_x[y],
            to_v = out.velocity_y[y], end](int i) {
        const Velocity<Number> limit = terminal<Number>(south, here, north, i, c);
        const Number u = at<Number>(to_u, i), v = at<Number>(to_v, i);
        const auto rolls = at<Number>(rolling, i) > S{0};
        store_before<Number>(end, select(rolls, u + c.relaxed * (limit.u - u), Number(0)), to_u, i);
        store_before<Number>(end, select(rolls, v + c.relaxed * (limit.v - v), Number(0)), to_v, i);
    };
}

// Sets the velocity in the halo: mirrored at a wall, otherwise 0. Rows y = 0 … ny-1; the first and the last
// also fill the halo rows beside them.
template <class Number, class S = Scalar<Number>>
void end_velocity(const StageRows<S>& w, StateRows<S>& out, int y, Span x) {
    S *u = out.velocity_x[y], *v = out.velocity_y[y];
    const auto mirrored = [&](Side side, S value) { return w.is_wall(side) ? value : S{0}; };
    if (x.first == 0) {
        u[-2] = u[-1] = mirrored(kWest, -u[0]);
        v[-2] = v[-1] = mirrored(kWest, v[0]);
    }
    if (x.last == w.nx) {
        u[w.nx + 1] = u[w.nx] = mirrored(kEast, -u[w.nx - 1]);
        v[w.nx + 1] = v[w.nx] = mirrored(kEast, v[w.nx - 1]);
    }
    const auto beyond = [&](Side side, int row) {
        S *u_beyond = out.velocity_x[row], *v_beyond = out.velocity_y[row];
        for (int i = x.first; i < x.last; ++i) {
            u_beyond[i] = mirrored(side, u[i]);
            v_beyond[i] = mirrored(side, -v[i]);
        }
    };
    if (y == 0) beyond(kSouth, -1);
    if (y == w.ny - 1) beyond(kNorth, w.ny);
}

}  // namespace sim::inertial
