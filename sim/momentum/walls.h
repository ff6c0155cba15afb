#pragma once

#include "sim/momentum/ground.h"

// Walls: faces at which sculpted or built ground rises by more than tan 30°, away from the vertex k before it.
//
//            ┌──── z_q      s = h_q − h_k − R_k > 0     how far the wall stands out of the layer
//       s  ↕ │              v_n                          speed of k toward the wall
//     ▒▒▒▒▒▒▒│ z_k
//        k      q
//
//     B            k and q are as level as the ground beside them: the face is a mirror
//     ∇z of k      a mirror while s > 0: a layer leans on a wall, and is not thrown back by its height
//     ∇z of q      a mirror while q's layer shoots away from the face, v² > g R: no wave runs back over it
//     v_n²/2g ≤ s  v_n := 0, and nothing passes: what arrives piles up, until s ≤ 0, and then flows over
//     else         flux and v_n that pass are multiplied by √(1 − s/(v_n²/2g)), without turning
//
// What falls from q to k falls freely. Without this rule the slope of a steep face would be gravity's to act on: a
// frictionless flow of 10 m/s passes a wall of 8 m, and what comes back from one of 15 m has 17 m/s.

namespace sim::momentum {

template <class S>
struct WallRows {
    const S *x, *south, *north;  // faces beside a row: along x, to the south, to the north
};
template <bool has_things, class S>
[[gnu::always_inline]] inline WallRows<S> wall_rows(const StageRows<S>& w, int y) {
    if constexpr (has_things) return {w.things.wall_x[y], w.things.wall_y[y], w.things.wall_y[y + 1]};
    return {};
}

// A row of what stands in a world.
template <bool has_things, class S>
[[gnu::always_inline]] inline const S* thing_row(const Rows<S>& rows, int y) {
    if constexpr (has_things) return rows[y];
    return nullptr;
}
// The smoothed ground along which a flow bends: without earth and buildings.
template <bool has_things, class S>
[[gnu::always_inline]] inline GroundRows<S> smooth_rows(const StageRows<S>& w, int y) {
    const auto row = [&](int at) -> GroundRow<S> {
        if constexpr (has_things) return {w.things.natural[at], w.smooth_depth[at]};
        return {w.bedrock[at], w.smooth_depth[at]};
    };
    return {row(y - 1), row(y), row(y + 1)};
}

// Rise of bedrock from a vertex through the walls on its sides, m; negative where they fall, 0: no wall.
template <class Number>
struct WallSides {
    Number west, east, south, north;

    auto any_wall() const {
        return max(max(abs(west), abs(east)), max(abs(south), abs(north))) > Scalar<Number>{0};
    }
};
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline WallSides<Number> wall_sides(const WallRows<S>& walls, int i) {
    return {-at<Number>(walls.x, i), at<Number>(walls.x, i + 1), -at<Number>(walls.south, i),
            at<Number>(walls.north, i)};
}

// Walls as they act on the layer of a vertex: s on each side, m; 0 where nothing stands out of it. −1: the layer shoots
// away from an edge.
template <class Number>
struct WallsAround {
    Number west, east, south, north;

    // A rise of the surface toward a side, or 0 where it is a mirror.
    Number beside(const Number& rise, const Number& side) const {
        return select(abs(side) > Scalar<Number>{0}, Number(0), rise);
    }
    // A velocity, slowed if it is toward a wall that its head does not reach over, as by a wall around the world
    // (finish.h).
    Number stop_x(const Number& u, const Number& r, Scalar<Number> courant) const {
        return stopped(u, east, west, r, courant);
    }
    Number stop_y(const Number& v, const Number& r, Scalar<Number> courant) const {
        return stopped(v, north, south, r, courant);
    }

  private:
    static Number stopped(const Number& velocity, const Number& ahead, const Number& behind, const Number& r,
                          Scalar<Number> courant) {
        using S = Scalar<Number>;
        const Number stands_out = select(velocity > S{0}, ahead, behind);
        const auto stops = stands_out > S{0} && velocity * velocity <= S(2 * kGravity) * stands_out;
        if (!any(stops)) return velocity;
        const Number slower =
            velocity / (Number(1) + courant * (abs(velocity) + sqrt(Number(S(kGravity) * r))));
        return select(stops, slower, velocity);
    }
};
// The same in a world without things.
struct NoWalls {
    struct None {};
    None west, east, south, north;

    template <class Number>
    [[gnu::always_inline]] static Number beside(const Number& rise, None) {
        return rise;
    }
    template <class Number>
    [[gnu::always_inline]] static Number stop_x(const Number& u, const Number&, Scalar<Number>) {
        return u;
    }
    template <class Number>
    [[gnu::always_inline]] static Number stop_y(const Number& v, const Number&, Scalar<Number>) {
        return v;
    }
};
// Around a vertex whose layer of thickness r moves with (u, v).
template <bool has_things, class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline auto walls_around(const WallRows<S>& walls, const GroundRows<S>& ground, int i,
                                                const Number& r, const Number& u, const Number& v) {
    if constexpr (!has_things) {
        return NoWalls{};
    } else {
        const Number none(0);
        const WallSides<Number> sides = wall_sides<Number>(walls, i);
        if (!any(sides.any_wall())) return WallsAround<Number>{none, none, none, none};
        const Number d = at<Number>(ground.here.depth, i), wave = S(kGravity) * r;
        const auto of = [&](const Number& rise, const S* beyond, int j, const Number& away) {
            const Number stands_out = max((rise + (at<Number>(beyond, j) - d)) - r, none);
            const auto shoots = rise < S{0} && away > S{0} && away * away > wave;
            return select(rise > S{0}, stands_out, select(shoots, Number(-1), none));
        };
        return WallsAround<Number>{
            of(sides.west, ground.here.depth, i - 1, u), of(sides.east, ground.here.depth, i + 1, -u),
            of(sides.south, ground.south.depth, i, v), of(sides.north, ground.north.depth, i, -v)};
    }
}

// The gradient of ground whose walls are mirrors.
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Gradient<Number> gradient(const GroundRows<S>& rows, int i,
                                                        const WallSides<Number>& walls,
                                                        const Constants<S>& c) {
    const auto open = [](const Number& rise, const Number& wall) {
        return select(abs(wall) > S{0}, Number(0), rise);
    };
    return {(open(rise<Number>(rows.here, i - 1, rows.here, i), walls.west) +
             open(rise<Number>(rows.here, i, rows.here, i + 1), walls.east)) *
                c.per_two_cells,
            (open(rise<Number>(rows.south, i, rows.here, i), walls.south) +
             open(rise<Number>(rows.here, i, rows.north, i), walls.north)) *
                c.per_two_cells};
}
// That of any vertex.
template <bool has_things, class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Gradient<Number> gradient_beside(const GroundRows<S>& rows, int i,
                                                               const WallRows<S>& walls,
                                                               const Constants<S>& c) {
    Gradient<Number> b = gradient<Number>(rows, i, c);
    if constexpr (has_things) {
        const WallSides<Number> sides = wall_sides<Number>(walls, i);
        const auto has_wall = sides.any_wall();
        if (any(has_wall)) {
            const Gradient<Number> mirrored = gradient<Number>(rows, i, sides, c);
            b = {select(has_wall, mirrored.x, b.x), select(has_wall, mirrored.y, b.y)};
        }
    }
    return b;
}

// The share of a flux, and of its velocity, that passes a wall; v_n toward it.
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Number share_over(const Number& stands_out, const Number& toward) {
    constexpr S kTwoG = S(2 * kGravity);
    const Number squared = toward * toward;
    const auto passes = toward > S{0} && squared > kTwoG * stands_out;
    return select(passes,
                  sqrt(max(Number(1) - kTwoG * stands_out / select(passes, squared, Number(1)), Number(0))),
                  Number(0));
}

// Rows y = 0 … ny-1. Reads b, d, s, R, of a world with things also walls; writes slope_x, slope_y, cosine and, with
// levelling, surface_x and surface_y, where the layer or a neighbour rolls.
template <class Number, bool has_things = false, class S = Scalar<Number>>
auto find_ground(const StageRows<S>& w, Fields<Rows<S>>& to, int y) {
    return [c = w.c, ground = ground_rows(w, w.u0.depth, y), smooth = ground_rows(w, w.smooth_depth, y),
            walls = wall_rows<has_things>(w, y), rolling = around(w.u0.rolling, y), slope_x = to.slope_x[y],
            slope_y = to.slope_y[y], cosine = to.cosine[y], surface_x = to.surface_x[y],
            surface_y = to.surface_y[y]](int i) {
        const Number across = max(at<Number>(rolling.here, i - 1), at<Number>(rolling.here, i + 1));
        const Number along = max(at<Number>(rolling.south, i), at<Number>(rolling.north, i));
        if (!any(max(max(across, along), at<Number>(rolling.here, i)) > S{0})) return;
        const Gradient<Number> b = gradient_beside<has_things, Number>(smooth, i, walls, c);
        store(b.x, slope_x + i), store(b.y, slope_y + i);
        store(cosine_of(b), cosine + i);
        if (!(c.levelling > S{0})) return;
        const Rises<Number> z = surface_rises<Number>(ground, rolling, i);
        store(half_mean_slope(z.west, z.east), surface_x + i);
        store(half_mean_slope(z.south, z.north), surface_y + i);
    };
}
// Beyond the border the ground is level; nothing that arrives there is seen again. Rows y = -1 … ny.
template <class Number, class S = Scalar<Number>>
void end_ground(const StageRows<S>& w, Fields<Rows<S>>& to, int y, Span x) {
    S *slope_x = to.slope_x[y], *slope_y = to.slope_y[y], *cosine = to.cosine[y];
    S *surface_x = to.surface_x[y], *surface_y = to.surface_y[y];
    const auto level = [&](int i) {
        slope_x[i] = slope_y[i] = surface_x[i] = surface_y[i] = 0, cosine[i] = 1;
    };
    if (w.is_ground(y))
        level(-1), level(w.nx);
    else
        for (int i = x.first; i < x.last; ++i) level(i);
}

}  // namespace sim::momentum
