#pragma once

#include "sim/inertial/fields.h"
#include "sim/inertial/limiter.h"
#include "sim/stages/stages.h"

// Flux of layer and momentum through a face, second order if both are smooth:
//
//     beyond   left | right   beyond      q_l = q_left + ½ σ_left,  q_r = q_right − ½ σ_right
//      x−2     x−1  |   x      x+1        q = R, u, v; σ the limited slope of a vertex (limiter.h)
//
//     w = (R_l v_l + R_r v_r) / (R_l + R_r)     the joint velocity across the face
//     w > 0:  F = min(R_l w Δt/Δx, ¼ R_left),    momentum F (u_l, v_l)
//     w < 0:  the mirror image
//
// The face has one velocity for the material on both sides. If each vertex used its own (as in flux-vector
// splitting), streams that meet in a gully would pass through each other, and a real avalanche would cover
// three times its area. At most a quarter of a vertex passes each of its four faces, so its outflow never
// exceeds its layer. At Courant numbers below a quarter this limit is not reached.
//
// A vertex that began the sub-step with ten quanta or less has no outflow. The mean of two stages leaves at
// least half of the initial layer at a vertex. Rounding at four faces and of the exchange takes less than a
// quantum each. Nothing passes a wall.

namespace sim::inertial {

// Rows y = 0 … ny-1. Reads R, velocity; writes half slopes.
template <class Number, class S = Scalar<Number>>
auto find_slopes(const StateRows<S>& from, StateRows<S>& out, int y) {
    struct Slopes {
        const S *south, *here, *north;
        S *to_x, *to_y;
        void operator()(int i) const {
            const Number value = at<Number>(here, i);
            store(half_monotonized<Number>(value - at<Number>(here, i - 1), at<Number>(here, i + 1) - value),
                  to_x + i);
            store(half_monotonized<Number>(value - at<Number>(south, i), at<Number>(north, i) - value),
                  to_y + i);
        }
    };
    const auto of = [y](const Rows<S>& rows, Rows<S>& to_x, Rows<S>& to_y) {
        return Slopes{rows[y - 1], rows[y], rows[y + 1], to_x[y], to_y[y]};
    };
    return
        [rolling = of(from.rolling, out.rolling_x, out.rolling_y), u = of(from.velocity_x, out.u_x, out.u_y),
         v = of(from.velocity_y, out.v_x, out.v_y)](int i) { rolling(i), u(i), v(i); };
}
// Beyond the border they go on level. Rows y = -1 … ny.
template <class Number, class S = Scalar<Number>>
void end_slopes(const StageRows<S>& w, StateRows<S>& out, int y, Span x) {
    if (w.is_ground(y))
        for (S* row : {out.rolling_x[y], out.u_x[y], out.v_x[y]}) row[-1] = row[w.nx] = 0;
    else
        for (S* row : {out.rolling_y[y], out.u_y[y], out.v_y[y]})
            std::fill(row + x.first, row + x.last, S{0});
}

// The values on both sides of a face.
template <class Number>
struct Sides {
    Number left, right;
};
// Extrapolates to the face from values and half slopes at the vertices.
template <class Number>
[[gnu::always_inline]] inline Sides<Number> at_face(const Sides<Number>& value,
                                                    const Sides<Number>& half_slope) {
    return {value.left + half_slope.left, value.right - half_slope.right};
}

template <class Number>
struct Flux {
    Number depth, across, along;  // m, and its momentum of both velocity components, m²/s
};

// Computes the flux through a face. `begun` (R at the start of the sub-step) and `rolls` are values at the
// vertices, the others at the face. `across` is the velocity through the face, `along` the other component.
template <class Number>
[[gnu::always_inline]] inline Flux<Number> flux_of(const Sides<Number>& begun, const Sides<Number>& rolls,
                                                   const Sides<Number>& rolling, const Sides<Number>& across,
                                                   const Sides<Number>& along,
                                                   const Constants<Scalar<Number>>& c) {
    using S = Scalar<Number>;
    constexpr S kMost = S(0.25), kThin = 10 * kGrain<Number>;
    const Number none(0);
    // Rounding may leave R at an empty face slightly below 0; then w would no longer be a mean.
    const Number r_l = max(rolling.left, none), r_r = max(rolling.right, none);
    const Number both = max(r_l + r_r, Number(S(1e-30)));  // avoids 0/0
    const Number w = (r_l * across.left + r_r * across.right) / both;
    const auto forth = w > S{0};
    const auto may = select(forth, begun.left, begun.right) > kThin;
    const Number most = select(may, kMost * select(forth, rolls.left, rolls.right), none);
    const Number f = max(min(c.courant * select(forth, r_l, r_r) * w, most), -most);
    return {f, f * select(forth, across.left, across.right), f * select(forth, along.left, along.right)};
}

// Along x, faces y = 0 … ny. Reads R, velocity and their slopes, and R of u0; writes fluxes and momentum.
template <class Number, class S = Scalar<Number>>
auto find_fluxes_x(const StageRows<S>& w, const StateRows<S>& from, StateRows<S>& out, int y) {
    return [c = w.c, begun = w.u0.rolling[y], rolling = from.rolling[y], u = from.velocity_x[y],
            v = from.velocity_y[y], slope = from.rolling_x[y], slope_u = from.u_x[y], slope_v = from.v_x[y],
            flux = out.flux_x[y], to_u = out.momentum_xu[y], to_v = out.momentum_xv[y]](int i) {
        const auto beside = [i](const S* row) {
            return Sides<Number>{at<Number>(row, i - 1), at<Number>(row, i)};
        };
        const Sides<Number> rolls = beside(rolling);
        if (!any(max(rolls.left, rolls.right) > S{0})) {  // true nearly everywhere
            for (S* row : {flux, to_u, to_v}) store(Number(0), row + i);
            return;
        }
        const Flux<Number> in = flux_of<Number>(beside(begun), rolls, at_face<Number>(rolls, beside(slope)),
                                                at_face<Number>(beside(u), beside(slope_u)),
                                                at_face<Number>(beside(v), beside(slope_v)), c);
        store(in.depth, flux + i), store(in.across, to_u + i), store(in.along, to_v + i);
    };
}
// Along y.
template <class Number, class S = Scalar<Number>>
auto find_fluxes_y(const StageRows<S>& w, const StateRows<S>& from, StateRows<S>& out, int y) {
    struct Pair {
        const S *south, *here;
        Sides<Number> operator()(int i) const { return {at<Number>(south, i), at<Number>(here, i)}; }
    };
    const auto pair = [y](const Rows<S>& rows) { return Pair{rows[y - 1], rows[y]}; };
    return [c = w.c, begun = pair(w.u0.rolling), rolling = pair(from.rolling), u = pair(from.velocity_x),
            v = pair(from.velocity_y), slope = pair(from.rolling_y), slope_u = pair(from.u_y),
            slope_v = pair(from.v_y), flux = out.flux_y[y], to_u = out.momentum_yu[y],
            to_v = out.momentum_yv[y]](int i) {
        const Sides<Number> rolls = rolling(i);
        if (!any(max(rolls.left, rolls.right) > S{0})) {
            for (S* row : {flux, to_u, to_v}) store(Number(0), row + i);
            return;
        }
        const Flux<Number> in =
            flux_of<Number>(begun(i), rolls, at_face<Number>(rolls, slope(i)),
                            at_face<Number>(v(i), slope_v(i)), at_face<Number>(u(i), slope_u(i)), c);
        store(in.depth, flux + i), store(in.across, to_v + i), store(in.along, to_u + i);
    };
}

// Nothing passes a wall. Faces y = 0 … ny.
template <class Number, class S = Scalar<Number>>
void end_fluxes(const StageRows<S>& w, StateRows<S>& out, int y, Span x) {
    for (S* row : {out.flux_x[y], out.momentum_xu[y], out.momentum_xv[y]}) {
        if (w.is_wall(kWest)) row[0] = 0;
        if (w.is_wall(kEast)) row[w.nx] = 0;
    }
    if ((y == 0 && w.is_wall(kSouth)) || (y == w.ny && w.is_wall(kNorth)))
        for (S* row : {out.flux_y[y], out.momentum_yu[y], out.momentum_yv[y]})
            std::fill(row + x.first, row + x.last, S{0});
}

}  // namespace sim::inertial
