#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>

#include "sim/simd/rows.h"
#include "sim/stages/field_list.h"
#include "sim/stages/world_rows.h"
#include "sim/world/params.h"
#include "sim/world/quanta.h"

// The constants and fields that the stages of `voellmy` work on: the only list of them.

namespace sim::voellmy {

inline constexpr double kGravity = 9.81;  // m/s²

// A layer this thin, ten quanta, does not move: rounding at four faces could take more than it has. m
template <class Number>
inline constexpr Scalar<Number> kThin = kHasQuanta<Number> ? 10 * kQuantum : 1e-12f;

// Constants of a sub-step, computed from parameters, cell size and sub-step. They are the same for all
// vertices.
template <class Scalar>
struct Constants {
    Scalar courant;           // Δt/Δx, s/m
    Dither<Scalar> dither;    // of the sub-step
    Scalar per_two_cells;     // 1/2Δx, 1/m
    Scalar per_four_squares;  // 1/4Δx², 1/m²

    Scalar fall;           // g Δt, m/s
    Scalar friction_time;  // μ Δt, s
    Scalar drag_length;    // g Δt/ξ, s: drag takes |v| times this, over the thickness normal to the slope
};

template <class Scalar>
Constants<Scalar> constants_of(const Params& p, float cell, Substep<Scalar> sub) {
    const Scalar dx = cell;
    return {.courant = sub.dt / dx,
            .dither = {sub.dither},
            .per_two_cells = 1 / (2 * dx),
            .per_four_squares = 1 / (4 * dx * dx),
            .fall = Scalar(kGravity) * sub.dt,
            .friction_time = p.friction * sub.dt,
            .drag_length = Scalar(kGravity) * sub.dt / Scalar{p.drag}};
}

// The layers, which belong to the world.
template <class Values>
struct MovingLayers {
    static constexpr bool kVelocityIsState = true;
    Values depth, rolling, velocity_x, velocity_y;  // m, m/s
};

// A face lies west (x) or south (y) of its vertex. `Values` is a field, or its rows.
template <class Values>
struct Fields {
    Values slope_x, slope_y, cosine;  // gradient B of b + d, and cos θ = 1/√(1 + |B|²)
    Values driven_u, driven_v;        // velocity after the forces of the sub-step, m/s
    // At half of the sub-step, by transport alone; and half of the limited slopes over a cell, along x and y.
    Values mid_rolling, mid_u, mid_v;  // m, m/s
    Values rolling_x, u_x, v_x;
    Values rolling_y, u_y, v_y;
    Values flux_x, flux_y;                                  // m through each face, to the east, to the north
    Values leaving_xu, leaving_xv, leaving_yu, leaving_yv;  // velocity of that flux where it comes from, m/s
    Values turned_xu, turned_xv, turned_yu, turned_yv;      // the same on the ground where it arrives
    Values share;  // the share of its wanted outflow that a vertex can give
};
template <class Visit, class... Lists>
constexpr void each_field(Visit&& visit, Lists&... f) {
    visit("slope_x", f.slope_x...);
    visit("slope_y", f.slope_y...);
    visit("cosine", f.cosine...);
    visit("driven_u", f.driven_u...);
    visit("driven_v", f.driven_v...);
    visit("mid_rolling", f.mid_rolling...);
    visit("mid_u", f.mid_u...);
    visit("mid_v", f.mid_v...);
    visit("rolling_x", f.rolling_x...);
    visit("u_x", f.u_x...);
    visit("v_x", f.v_x...);
    visit("rolling_y", f.rolling_y...);
    visit("u_y", f.u_y...);
    visit("v_y", f.v_y...);
    visit("flux_x", f.flux_x...);
    visit("flux_y", f.flux_y...);
    visit("leaving_xu", f.leaving_xu...);
    visit("leaving_xv", f.leaving_xv...);
    visit("leaving_yu", f.leaving_yu...);
    visit("leaving_yv", f.leaving_yv...);
    visit("turned_xu", f.turned_xu...);
    visit("turned_xv", f.turned_xv...);
    visit("turned_yu", f.turned_yu...);
    visit("turned_yv", f.turned_yv...);
    visit("share", f.share...);
}
static_assert(members_visited<Fields<char>>([](auto visit, auto& f) { each_field(visit, f); }) ==
              sizeof(Fields<char>));

template <class Scalar>
using LayerRows = MovingLayers<Rows<Scalar>>;

// What the stages read and write: rows of the fields, and values that all vertices share.
template <class Scalar>
struct StageRows : Fields<Rows<Scalar>>, WorldRows<Constants<Scalar>, Scalar> {
    LayerRows<Scalar> u0;
};

}  // namespace sim::voellmy
