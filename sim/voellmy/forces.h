#pragma once

#include "sim/voellmy/fields.h"
#include "sim/voellmy/ground.h"

// The forces of a sub-step on a layer of vertical thickness R with velocity v in plan, on ground with slope B
// and inclination θ, under the surface z = b + d + R:
//
//     gravity, pressure    v ← v − Δt g/(1 + max(B·∇z, 0)) ∇z
//     Coulomb              |v|ₛ ← max(0, |v|ₛ − Δt μ N)         N = cos θ · max(g + vᵀ H v, 0), at most 4 g cos θ
//     drag                 |v|ₛ ← |v|ₛ / (1 + Δt g |v₀|ₛ/(ξ R cos θ))
//
// |v|ₛ = √(|v|² + (B·v)²) is the speed along the slope, and friction scales v by what it leaves of it. The
// denominator of the pressure is 1 + B·∇z, not 1 + |∇z|²: pressure acts with cos⁴θ down the slope, cos²θ
// across it, and never turns around.
//
// Friction is implicit: it takes at most the speed that is there, after all other forces. So a layer stops
// exactly, within a sub-step, and a layer at rest stays at rest while the driving force is at most μ N. Drag is
// linearised around the speed before, v₀; terminal speed is exact.

namespace sim::voellmy {

// The greatest normal acceleration, as a multiple of g: on raw ground a single sharp vertex would stop a flow.
inline constexpr float kGreatestNormal = 4;

// Rows y = 0 … ny-1. Reads b, d, R, velocity, slope and cosine; writes driven_u and driven_v.
template <class Number, class S = Scalar<Number>>
auto drive(const StageRows<S>& w, Fields<Rows<S>>& to, int y) {
    return [c = w.c, south = ground_row(w, y - 1), here = ground_row(w, y), north = ground_row(w, y + 1),
            r_south = w.u0.rolling[y - 1], r_here = w.u0.rolling[y], r_north = w.u0.rolling[y + 1],
            from_u = w.u0.velocity_x[y], from_v = w.u0.velocity_y[y], slope_x = w.slope_x[y],
            slope_y = w.slope_y[y], cosine = w.cosine[y], to_u = to.driven_u[y],
            to_v = to.driven_v[y]](int i) {
        const Number none(0), r = at<Number>(r_here, i);
        const auto rolls = r > kThin<Number>;
        if (!any(rolls)) {  // as it is in most places
            store(none, to_u + i), store(none, to_v + i);
            return;
        }
        const Number bx = at<Number>(slope_x, i), by = at<Number>(slope_y, i), cos = at<Number>(cosine, i);
        const Number u = at<Number>(from_u, i), v = at<Number>(from_v, i);
        const auto squared_along_slope = [&](const Number& x, const Number& y) {
            const Number rises = bx * x + by * y;
            return (x * x + y * y) + rises * rises;
        };
        const Number zx = bx + (at<Number>(r_here, i + 1) - at<Number>(r_here, i - 1)) * c.per_two_cells;
        const Number zy = by + (at<Number>(r_north, i) - at<Number>(r_south, i)) * c.per_two_cells;
        const Number pull = c.fall / (Number(1) + max(bx * zx + by * zy, none));
        const Number driven_u = u - pull * zx, driven_v = v - pull * zy;

        const Number before = squared_along_slope(u, v);
        Number normal = Number(S(kGravity));
        if (any(before > S{0}))
            normal = min(max(normal + bending(south, here, north, i, u, v, c), none),
                         Number(S(kGreatestNormal * kGravity)));
        const Number speed = sqrt(squared_along_slope(driven_u, driven_v));
        const Number left = max(speed - c.friction_time * (cos * normal), none);
        const Number thick = r * cos;
        const Number kept =
            left * thick / max(speed * (thick + c.drag_length * sqrt(before)), Number(S(1e-30)));
        store(select(rolls, driven_u * kept, none), to_u + i);
        store(select(rolls, driven_v * kept, none), to_v + i);
    };
}
// Sets driven velocity in the halo: mirrored at a wall, otherwise 0. Rows y = 0 … ny-1; the first and the last
// also fill the halo rows beside them.
template <class Number, class S = Scalar<Number>>
void end_drive(const StageRows<S>& w, Fields<Rows<S>>& to, int y, Span x) {
    S *u = to.driven_u[y], *v = to.driven_v[y];
    const auto mirrored = [&](Side side, S value) { return w.is_wall(side) ? value : S{0}; };
    u[-1] = mirrored(kWest, -u[0]), v[-1] = mirrored(kWest, v[0]);
    u[w.nx] = mirrored(kEast, -u[w.nx - 1]), v[w.nx] = mirrored(kEast, v[w.nx - 1]);
    const auto beyond = [&](Side side, int row) {
        S *u_beyond = to.driven_u[row], *v_beyond = to.driven_v[row];
        for (int i = x.first; i < x.last; ++i) {
            u_beyond[i] = mirrored(side, u[i]);
            v_beyond[i] = mirrored(side, -v[i]);
        }
    };
    if (y == 0) beyond(kSouth, -1);
    if (y == w.ny - 1) beyond(kNorth, w.ny);
}

}  // namespace sim::voellmy
