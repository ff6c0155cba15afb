#pragma once

#include "sim/inertial/limiter.h"
#include "sim/inertial/work.h"
#include "sim/stages.h"

// Layer and momentum through a face, second order where they are smooth:
//
//     beyond   left | right   beyond      q_l = q_left + ½ σ_left,  q_r = q_right − ½ σ_right   for q = R, u,
//     v
//      x−2     x−1  |   x      x+1        σ the limited slope of a vertex (limiter.h)
//
//     w = (R_l v_l + R_r v_r) / (R_l + R_r)     the joint velocity across the face
//     w > 0:  F = min(R_l w Δt/Δx, ¼ R_left),    momentum F (u_l, v_l)
//     w < 0:  the mirror image
//
// One velocity of the material on both sides together: if each vertex gave by its own (as in flux-vector
// splitting), streams that meet in a gully would pass through each other, and a real avalanche spread over
// three times its ground. Through each of four faces goes a quarter of a vertex at most, which no flow asks
// for at a Courant number below a quarter: so none gives more than it has.
//
// What began the sub-step with ten quanta or less gives nothing; so neither does what was empty. The mean of
// two stages leaves a vertex at least half of what it began with, and rounding four faces and the exchange
// takes less than a quantum each. Walls let nothing pass.

namespace sim::inertial {

// Rows y = 0 … ny-1. Reads R, velocity; writes half slopes.
template <class Number, class S = Scalar<Number>>
auto find_slopes(const Level<S>& level, int y) {
    struct Slopes {
        const S *south, *here, *north;
        S *to_x, *to_y;
        void operator()(int i) const {
            const Number value = at<Number>(here, i);
            store(half_monotonized<Number>(value - at<Number, -1>(here, i), at<Number, 1>(here, i) - value),
                  to_x + i);
            store(half_monotonized<Number>(value - at<Number>(south, i), at<Number>(north, i) - value),
                  to_y + i);
        }
    };
    const auto of = [y](const Rows<S>& rows, const Rows<S>& to_x, const Rows<S>& to_y) {
        return Slopes{rows[y - 1], rows[y], rows[y + 1], to_x[y], to_y[y]};
    };
    return [rolling = of(level.rolling, level.rolling_x, level.rolling_y),
            u = of(level.velocity_x, level.u_x, level.u_y),
            v = of(level.velocity_y, level.v_x, level.v_y)](int i) { rolling(i), u(i), v(i); };
}
// Beyond the border they go on level. Rows y = -1 … ny.
template <class Number, class S = Scalar<Number>>
void end_slopes(const Work<S>& w, const Level<S>& level, int y, Span x) {
    if (w.is_ground(y))
        for (S* row : {level.rolling_x[y], level.u_x[y], level.v_x[y]}) row[-1] = row[w.nx] = 0;
    else
        for (S* row : {level.rolling_y[y], level.u_y[y], level.v_y[y]})
            std::fill(row + x.first, row + x.last, S{0});
}

// A value on both sides of a face.
template <class Number>
struct Sides {
    Number left, right;
};

template <class Number>
struct Flux {
    Number depth, across, along;  // m, and of both velocities the momentum that it takes along, m²/s
};

// `begun` and `rolls` at the vertices beside the face, the rest at the face: `across` is the velocity through
// it, `along` the other.
template <class Number>
[[gnu::always_inline]] inline Flux<Number> flux_of(const Sides<Number>& begun, const Sides<Number>& rolls,
                                                   const Sides<Number>& rolling, const Sides<Number>& across,
                                                   const Sides<Number>& along, const Constants<Scalar<Number>>& c) {
    using S = Scalar<Number>;
    constexpr S kMost = S(0.25), kThin = 10 * kGrain<Number>;
    const Number none(0);
    // Rounding may leave a face of nothing a hair below it, and w no mean any more.
    const Number r_l = larger(rolling.left, none), r_r = larger(rolling.right, none);
    const Number both = larger(r_l + r_r, Number(S(1e-30)));  // of nothing, 0 of anything
    const Number w = (r_l * across.left + r_r * across.right) / both;
    const auto forth = w > S{0};
    const auto may = select(forth, begun.left, begun.right) > kThin;
    const Number most = select(may, kMost * select(forth, rolls.left, rolls.right), none);
    const Number f = larger(smaller(c.courant * select(forth, r_l, r_r) * w, most), -most);
    return {f, f * select(forth, across.left, across.right), f * select(forth, along.left, along.right)};
}

// Faces y = 0 … ny. Reads R, velocity and their slopes, and R of `now`; writes fluxes and momentum.
template <class Number, class S = Scalar<Number>>
auto find_fluxes(const Work<S>& w, const Level<S>& level, int y) {
    struct Value {
        const S *south, *here, *x, *y_south, *y_here;
        Sides<Number> along_x(int i) const {
            return {at<Number, -1>(here, i) + at<Number, -1>(x, i), at<Number>(here, i) - at<Number>(x, i)};
        }
        Sides<Number> along_y(int i) const {
            return {at<Number>(south, i) + at<Number>(y_south, i),
                    at<Number>(here, i) - at<Number>(y_here, i)};
        }
    };
    const auto value = [&](const Rows<S>& rows, const Rows<S>& x, const Rows<S>& y_) {
        return Value{rows[y - 1], rows[y], x[y], y_[y - 1], y_[y]};
    };
    return [c = w.c, rolling = value(level.rolling, level.rolling_x, level.rolling_y),
            u = value(level.velocity_x, level.u_x, level.u_y),
            v = value(level.velocity_y, level.v_x, level.v_y), begun_south = w.now.rolling[y - 1],
            begun_here = w.now.rolling[y], flux_x = level.flux_x[y], flux_y = level.flux_y[y],
            xu = level.momentum_xu[y], xv = level.momentum_xv[y], yu = level.momentum_yu[y],
            yv = level.momentum_yv[y]](int i) {
        const Number here = at<Number>(rolling.here, i);
        const Number west = at<Number, -1>(rolling.here, i), south = at<Number>(rolling.south, i);
        if (!any(larger(here, larger(west, south)) > S{0})) {  // as it is nearly everywhere
            for (S* row : {flux_x, flux_y, xu, xv, yu, yv}) store(Number(0), row + i);
            return;
        }
        const Number begun = at<Number>(begun_here, i);
        const Flux<Number> in_x = flux_of<Number>({at<Number, -1>(begun_here, i), begun}, {west, here},
                                                  rolling.along_x(i), u.along_x(i), v.along_x(i), c);
        store(in_x.depth, flux_x + i), store(in_x.across, xu + i), store(in_x.along, xv + i);
        const Flux<Number> in_y = flux_of<Number>({at<Number>(begun_south, i), begun}, {south, here},
                                                  rolling.along_y(i), v.along_y(i), u.along_y(i), c);
        store(in_y.depth, flux_y + i), store(in_y.across, yv + i), store(in_y.along, yu + i);
    };
}

// Through a wall nothing passes. Faces y = 0 … ny.
template <class Number, class S = Scalar<Number>>
void end_fluxes(const Work<S>& w, const Level<S>& level, int y, Span x) {
    for (S* row : {level.flux_x[y], level.momentum_xu[y], level.momentum_xv[y]}) {
        if (w.is_wall(kWest)) row[0] = 0;
        if (w.is_wall(kEast)) row[w.nx] = 0;
    }
    if ((y == 0 && w.is_wall(kSouth)) || (y == w.ny && w.is_wall(kNorth)))
        for (S* row : {level.flux_y[y], level.momentum_yu[y], level.momentum_yv[y]})
            std::fill(row + x.first, row + x.last, S{0});
}

}  // namespace sim::inertial
