#pragma once

#include "sim/inertial/fields.h"
#include "sim/stages/stages.h"

// The velocity at which a layer would end on the surface as it lies now, by central differences over the
// vertex's four neighbours:
//
//            N              g_x = (E − W) / 2Δx
//            |              g_y = (N − S) / 2Δx          of z = h + R
//        W — C — E
//            |              v_eq = −(g/|g|) min(v_max, k_v |g|) R / (R + R_h)
//            S
//
// The slope of z rather than of h: it carries the lateral pressure, without which a flow digs itself into
// rills along the grid. Bedrock and layers are differenced apart: their sum would lose the layers' last
// digits.
//
// v += (1 − e^(−Δt/2τ)) (v_eq − v) for half a sub-step. It leaves b, d and R as they are, so v_eq stands
// while it lasts and the exponential is its exact answer, however short τ. Half of it before transport and
// exchange and half after (heun.h) make the sub-step second order (Strang 1968).

namespace sim::inertial {

template <class Number>
struct Velocity {
    Number u, v;  // m/s
};

// z on a row, and by how much it is higher at one vertex than at another, each so far aside of i.
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

// Of vertex i of `here`.
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

// Half of a sub-step's relaxation, toward the terminal velocity of a level: rows y = 0 … ny-1. Reads b and
// that level's d, R, and R of `now`; writes velocity of `now`, up to vertex `end`.
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

// Beyond the border what rolls has no velocity, but at a wall, where it is mirrored. Rows y = 0 … ny-1, the
// first and the last for the halo beside them too.
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
