#pragma once

#include "sim/momentum/fields.h"
#include "sim/momentum/friction.h"
#include "sim/momentum/ground.h"
#include "sim/momentum/walls.h"
#include "sim/momentum/water.h"

// The forces of a sub-step on a layer of vertical thickness R with velocity v in plan, on ground with slope B
// and inclination θ, under the surface z = b + d + R:
//
//     gravity, pressure    v ← v − Δt G ∇z                      G = g/(1 + max(B·∇z, 0))
//     friction             |v|ₛ ← max(0, |v|ₛ − Δt μ N)         N = cos θ · max(g + vᵀ H v, 0), at most 4 g cos θ
//     drag                 |v|ₛ ← |v|ₛ / (1 + Δt g |v₀|ₛ/(ξ R cos θ))         μ and ξ: friction.h
//     stems and posts      |v|ₛ ← |v|ₛ / (1 + ½ C_d A |v|ₛ Δt)          A: frontal area per volume (world/things.h)
//     wet ground           μ ← f μ                                      f: water.h
//
// |v|ₛ = √(|v|² + (B·v)²) is the speed along the slope, and friction scales v by what it leaves of it. The
// denominator of the pressure is 1 + B·∇z, not 1 + |∇z|²: pressure acts with cos⁴θ down the slope, cos²θ
// across it, and never turns around.
//
// Friction is implicit: it takes at most the speed that is there, after all other forces. So a layer stops
// exactly, within a sub-step, and a layer at rest stays at rest while the driving force is at most μ N. Drag is
// linearised around the speed before, v₀; terminal speed is exact.

namespace sim::momentum {

// The greatest normal acceleration, as a multiple of g: where the ground bends within few cells, H is a guess.
inline constexpr float kGreatestNormal = 4;

// A surface that falls by less than this share of a layer counts as level.
inline constexpr float kLevel = 0.125f;

// (G |∇z|ₛ)², by which gravity and pressure drive a layer along the slope, times Δt².
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Number drive_squared(const Gradient<Number>& b, const Gradient<Number>& z,
                                                   S fall) {
    const Number rises = b.x * z.x + b.y * z.y;
    const Number pull = fall / (Number(1) + max(rises, Number(0)));
    return (pull * pull) * (z.squared() + rises * rises);
}

// ∇z as it drives a layer of thickness `own` with velocity (u, v). In a pit along x or y, where the surface rises on
// both sides by more than that, a side where less than half as much rolls may brake, but not drive: what stands still beside a
// layer, as the wall of a hole does, would push it for ever. With levelling, which takes back what is pushed uphill, level
// ground is pit enough: else a layer is pushed for ever up to that depth, and both layers in a pond of two cells together.
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Gradient<Number> driving_gradient(const GroundRows<S>& ground,
                                                                const LayerAround<S>& rolling, int i,
                                                                const Number& own, const Number& u,
                                                                const Number& v, const Constants<S>& c,
                                                                const auto& walls) {
    const Number none(0), deep = c.levelling > S{0} ? Number(S(-kLevel) * own) : own;
    const auto of = [&](const Number& rise_back, const Number& rise_ahead, const Number& r_back,
                        const Number& r_ahead, const Number& velocity, const auto& wall_back,
                        const auto& wall_ahead) {
        const Number back = walls.beside(rise_back, wall_back), ahead = walls.beside(rise_ahead, wall_ahead);
        const Number mean = (back + ahead) * c.per_two_cells;
        const auto pit = min(-back, ahead) > deep && mean * velocity <= S{0};
        const Number beside = select(mean < S{0}, r_back, r_ahead);  // on the higher side
        return select(pit && beside < S(0.5) * own, none, mean);
    };
    const Rises<Number> z = surface_rises<Number>(ground, rolling, i);
    return {of(z.west, z.east, at<Number>(rolling.here, i - 1), at<Number>(rolling.here, i + 1), u,
               walls.west, walls.east),
            of(z.south, z.north, at<Number>(rolling.south, i), at<Number>(rolling.north, i), v, walls.south,
               walls.north)};
}

// Rows y = 0 … ny-1. Reads b, d, s, R, velocity, slope and cosine, of a world with things also drag, water and walls;
// writes driven_u, driven_v and, if `exchanges`, held: whether gravity and pressure are at most the friction of a layer at
// rest, or friction stopped it.
template <class Number, bool exchanges, bool has_things = false, class S = Scalar<Number>>
auto drive(const StageRows<S>& w, Fields<Rows<S>>& to, int y) {
    return [c = w.c, ground = ground_rows(w, w.u0.depth, y), smooth = smooth_rows<has_things>(w, y),
            walls = wall_rows<has_things>(w, y), stems = thing_row<has_things>(w.things.drag, y),
            water = thing_row<has_things>(w.things.water, y), rolling = around(w.u0.rolling, y),
            from_u = w.u0.velocity_x[y], from_v = w.u0.velocity_y[y], slope_x = w.slope_x[y],
            slope_y = w.slope_y[y], cosine = w.cosine[y], to_u = to.driven_u[y], to_v = to.driven_v[y],
            to_held = to.held[y]](int i) {
        const Number none(0), r = at<Number>(rolling.here, i);
        const auto rolls = r > kThin<Number>;
        if (!any(rolls)) {  // as it is in most places
            store(none, to_u + i), store(none, to_v + i);
            if constexpr (exchanges) store(none, to_held + i);
            return;
        }
        const Gradient<Number> b{at<Number>(slope_x, i), at<Number>(slope_y, i)};
        const Number cos = at<Number>(cosine, i), u = at<Number>(from_u, i), v = at<Number>(from_v, i);
        const auto squared_along_slope = [&](const Number& east, const Number& north) {
            const Number rises = b.x * east + b.y * north;
            return (east * east + north * north) + rises * rises;
        };
        const auto around_it = walls_around<has_things, Number>(walls, ground, i, r, u, v);
        const Gradient<Number> z = driving_gradient<Number>(ground, rolling, i, r, u, v, c, around_it);
        const Number pull = c.fall / (Number(1) + max(b.x * z.x + b.y * z.y, none));
        const Number driven_u = u - pull * z.x, driven_v = v - pull * z.y;

        const Number before = squared_along_slope(u, v);
        Number normal = Number(S(kGravity));
        if (any(before > S{0}))
            normal =
                min(max(normal + bending(smooth, i, u, v, c), none), Number(S(kGreatestNormal * kGravity)));
        const Number thick = r * cos;
        Friction<Number> friction = friction_of(thick, cos, before, normal, c);
        if constexpr (has_things) friction = friction * effective_share<Number>(water, i, c);
        const Number speed = sqrt(squared_along_slope(driven_u, driven_v));
        const Number left = max(speed - (c.time * (friction.moves * cos)) * normal, none);
        Number kept =
            left * thick / max(speed * (thick + drag_length_of(thick, c) * sqrt(before)), Number(S(1e-30)));
        if constexpr (has_things) {
            const Number area = at<Number>(stems, i);
            if (any(area > S{0})) kept /= Number(1) + (c.stem_drag * area) * (speed * kept);
        }
        store(select(rolls, around_it.stop_x(Number(driven_u * kept), r, c.courant), none), to_u + i);
        store(select(rolls, around_it.stop_y(Number(driven_v * kept), r, c.courant), none), to_v + i);
        if constexpr (exchanges) {
            const Number holds = c.fall * (friction.rests * cos);
            const auto held = left <= S{0} || drive_squared(b, z, c.fall) <= holds * holds;
            store(select(rolls && held, Number(1), none), to_held + i);
        }
    };
}
// Sets values in the halo: mirrored at a wall, with this sign along x or y, otherwise 0. Rows y = 0 … ny-1; the
// first and the last also fill the halo rows beside them.
template <class Number, class S = Scalar<Number>>
void end_mirrored(const StageRows<S>& w, Rows<S>& to, S sign_x, S sign_y, int y, Span x) {
    S* row = to[y];
    const auto mirrored = [&](Side side, S value) { return w.is_wall(side) ? value : S{0}; };
    row[-1] = mirrored(kWest, sign_x * row[0]), row[w.nx] = mirrored(kEast, sign_x * row[w.nx - 1]);
    const auto beyond = [&](Side side, S* halo) {
        for (int i = x.first; i < x.last; ++i) halo[i] = mirrored(side, sign_y * row[i]);
    };
    if (y == 0) beyond(kSouth, to[-1]);
    if (y == w.ny - 1) beyond(kNorth, to[w.ny]);
}
template <class Number, class S = Scalar<Number>>
void end_drive(const StageRows<S>& w, Fields<Rows<S>>& to, int y, Span x) {
    end_mirrored<Number>(w, to.driven_u, S{-1}, S{1}, y, x);
    end_mirrored<Number>(w, to.driven_v, S{1}, S{-1}, y, x);
}

}  // namespace sim::momentum
