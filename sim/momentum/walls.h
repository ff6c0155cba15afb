#pragma once

#include "sim/momentum/ground.h"

// Walls: faces at which sculpted or built ground rises by more than tan 30°, away from the vertex k before it.
//
//            ┌──── z_q      s = h_q − h_k − R_k > 0     how far the wall stands out of the layer
//       s  ↕ │              v_n                          speed of k toward the wall
//     ▒▒▒▒▒▒▒│ z_k
//        k      q
//
//     the face is a mirror in ∇z and B at k            a layer leans on a wall, and is not thrown back by its height
//     v_n²/2g ≤ s:   v_n := 0, and nothing passes       what arrives piles up, until s ≤ 0: then it flows over
//     else:          flux and v_n that pass are multiplied by √(1 − s/(v_n²/2g)), without turning
//
// Otherwise the slope of a steep face would be gravity's to act on: without this rule a frictionless flow of 10 m/s
// passes a wall of 40 m, and falls back at 56 m/s. From q down to k nothing changes.

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

// s on each side of a vertex, m; 0 where there is no wall, or the layer reaches over it.
template <class Number>
struct WallsAround {
    Number west, east, south, north;

    auto any_stands_out() const { return max(max(west, east), max(south, north)) > Scalar<Number>{0}; }
    // A rise, or 0 on the side of a wall.
    Number beside(const Number& rise, const Number& stands_out) const {
        return select(stands_out > Scalar<Number>{0}, Number(0), rise);
    }
    // A velocity, or 0 if it is toward a wall that its head does not reach over.
    Number stop_x(const Number& u) const { return stopped(u, east, west); }
    Number stop_y(const Number& v) const { return stopped(v, north, south); }

  private:
    static Number stopped(const Number& velocity, const Number& ahead, const Number& behind) {
        using S = Scalar<Number>;
        const Number stands_out = select(velocity > S{0}, ahead, behind);
        return select(stands_out > S{0} && velocity * velocity <= S(2 * kGravity) * stands_out, Number(0),
                      velocity);
    }
};
// The same in a world without things.
struct NoWalls {
    struct None {};
    None west, east, south, north;

    template <class Number>
    [[gnu::always_inline]] const Number& beside(const Number& rise, None) const {
        return rise;
    }
    template <class Number>
    [[gnu::always_inline]] Number stop_x(const Number& u) const {
        return u;
    }
    template <class Number>
    [[gnu::always_inline]] Number stop_y(const Number& v) const {
        return v;
    }
};
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline WallsAround<Number> walls_around(const WallRows<S>& walls,
                                                               const GroundRows<S>& ground, int i,
                                                               const Number& r) {
    const Number none(0);
    const Number west = -at<Number>(walls.x, i), east = at<Number>(walls.x, i + 1),
                 south = -at<Number>(walls.south, i), north = at<Number>(walls.north, i);
    if (!any(max(max(west, east), max(south, north)) > S{0})) return {none, none, none, none};
    const Number d = at<Number>(ground.here.depth, i);
    const auto of = [&](const Number& rise, const S* beyond, int j) {
        return select(rise > S{0}, max((rise + (at<Number>(beyond, j) - d)) - r, none), none);
    };
    return {of(west, ground.here.depth, i - 1), of(east, ground.here.depth, i + 1),
            of(south, ground.south.depth, i), of(north, ground.north.depth, i)};
}

template <bool has_things, class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline auto walls_of(const WallRows<S>& walls, const GroundRows<S>& ground, int i,
                                            const Number& r) {
    if constexpr (has_things)
        return walls_around<Number>(walls, ground, i, r);
    else
        return NoWalls{};
}

// The gradient of ground whose sides at walls are mirrors.
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Gradient<Number> gradient(const GroundRows<S>& rows, int i,
                                                        const WallsAround<Number>& walls,
                                                        const Constants<S>& c) {
    return {(walls.beside(rise<Number>(rows.here, i - 1, rows.here, i), walls.west) +
             walls.beside(rise<Number>(rows.here, i, rows.here, i + 1), walls.east)) *
                c.per_two_cells,
            (walls.beside(rise<Number>(rows.south, i, rows.here, i), walls.south) +
             walls.beside(rise<Number>(rows.here, i, rows.north, i), walls.north)) *
                c.per_two_cells};
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

// Rows y = 0 … ny-1. Reads b, s, R, of a world with things also d and walls; writes slope_x, slope_y and cosine, where
// the layer or a neighbour rolls.
template <class Number, bool has_things = false, class S = Scalar<Number>>
auto find_ground(const StageRows<S>& w, Fields<Rows<S>>& to, int y) {
    return [c = w.c, smooth = ground_rows(w, w.smooth_depth, y), ground = ground_rows(w, w.u0.depth, y),
            walls = wall_rows<has_things>(w, y), rolling = around(w.u0.rolling, y), slope_x = to.slope_x[y],
            slope_y = to.slope_y[y], cosine = to.cosine[y]](int i) {
        const Number across = max(at<Number>(rolling.here, i - 1), at<Number>(rolling.here, i + 1));
        const Number along = max(at<Number>(rolling.south, i), at<Number>(rolling.north, i));
        if (!any(max(max(across, along), at<Number>(rolling.here, i)) > S{0})) return;
        Gradient<Number> b = gradient<Number>(smooth, i, c);
        if constexpr (has_things) {
            const auto around_it = walls_around<Number>(walls, ground, i, at<Number>(rolling.here, i));
            const auto leans = around_it.any_stands_out();
            if (any(leans)) {
                const Gradient<Number> mirrored = gradient<Number>(smooth, i, around_it, c);
                b = {select(leans, mirrored.x, b.x), select(leans, mirrored.y, b.y)};
            }
        }
        store(b.x, slope_x + i), store(b.y, slope_y + i);
        store(cosine_of(b), cosine + i);
    };
}
// Beyond the border the ground is level; nothing that arrives there is seen again. Rows y = -1 … ny.
template <class Number, class S = Scalar<Number>>
void end_ground(const StageRows<S>& w, Fields<Rows<S>>& to, int y, Span x) {
    S *slope_x = to.slope_x[y], *slope_y = to.slope_y[y], *cosine = to.cosine[y];
    const auto level = [&](int i) { slope_x[i] = slope_y[i] = 0, cosine[i] = 1; };
    if (w.is_ground(y))
        level(-1), level(w.nx);
    else
        for (int i = x.first; i < x.last; ++i) level(i);
}

}  // namespace sim::momentum
