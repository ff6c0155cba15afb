#pragma once

#include <string_view>

#include "sim/simd/exponential.h"
#include "sim/simd/rows.h"
#include "sim/stages/field_list.h"
#include "sim/stages/world_rows.h"
#include "sim/world/params.h"
#include "sim/world/quanta.h"

// The constants and fields that the stages of `bcre-inertial` work on: the only list of them.

namespace sim::inertial {

// A layer thinner than this counts as none, m; a quantum is 7.6e-6 m.
inline constexpr float kNothing = 1e-12f;

// Constants of a sub-step, computed from parameters, cell size and sub-step. They are the same for all
// vertices.
template <class Scalar>
struct Constants {
    Scalar courant;         // Δt/Δx, s/m
    Dither<Scalar> dither;  // of the sub-step
    Scalar dx, per_cell;    // m, 1/m

    Scalar speed_per_slope, max_speed, half_speed_depth;
    Scalar nearly_capped_squared;  // squared slope just below the one that gives max_speed
    Scalar relaxed;                // relaxed share of v_eq − v in half a sub-step

    Scalar pace;  // γ Δt
    Scalar exchange_depth, stop_slope_thick, stop_slope_more, per_fold_depth;
    Scalar greatest_stop_slope;  // just above the stop slope of any layer
    Scalar per_deposit_speed, erosion_slope, erosion_depth;

    Scalar start_slope, start_depth, freeze_depth, slow_squared, anchor_gain, anchor_margin;
};

template <class Scalar>
Constants<Scalar> constants_of(const Params& p, float cell, Substep<Scalar> sub) {
    const Scalar dx = cell, deposit_speed = p.deposit_speed;
    const Scalar capped = Scalar{p.max_speed} / Scalar{p.speed_per_slope};
    return {.courant = sub.dt / dx,
            .dither = {sub.dither},
            .dx = dx,
            .per_cell = 1 / dx,
            .speed_per_slope = p.speed_per_slope,
            .max_speed = p.max_speed,
            .half_speed_depth = p.half_speed_depth,
            .nearly_capped_squared = capped * capped * Scalar(0.9999),
            .relaxed = 1 - exp(Scalar(-0.5) * sub.dt / Scalar{p.relaxation_time}),
            .pace = p.exchange_rate * sub.dt,
            .exchange_depth = p.exchange_depth,
            .stop_slope_thick = p.stop_slope_thick,
            .stop_slope_more = Scalar{p.stop_slope} - Scalar{p.stop_slope_thick},
            .per_fold_depth = 1 / Scalar{p.stop_fold_depth},
            .greatest_stop_slope = std::max(p.stop_slope, p.stop_slope_thick) * Scalar(1.0001),
            .per_deposit_speed = 1 / deposit_speed,
            .erosion_slope = p.erosion_slope,
            .erosion_depth = p.erosion_depth,
            .start_slope = p.start_slope,
            .start_depth = nearest_quanta(Scalar{p.start_depth}),
            .freeze_depth = p.freeze_depth,
            .slow_squared = deposit_speed * deposit_speed,
            .anchor_gain = p.anchor_gain,
            .anchor_margin = p.anchor_margin + p.anchor_step / dx};
}

// A Runge–Kutta state: the layers with their velocity, and their rates of change. A face lies west (x) or
// south (y) of its vertex. `Values` is a field, or its rows.
template <class Values>
struct RkState {
    static constexpr bool kVelocityIsState = true;
    Values depth, rolling, velocity_x, velocity_y;  // m, m/s
    Values drop_x, drop_y;            // m by which h falls through each face, to the east, to the north
    Values curvature_x, curvature_y;  // second-order part of a drop, m
    Values exchanged;                 // m in the sub-step, erosion positive
    Values rolling_x, u_x, v_x;       // half of the limited slope of R and velocity along x, over a cell
    Values rolling_y, u_y, v_y;       // along y
    Values flux_x, flux_y;            // m through each face in the sub-step, to the east, to the north
    Values momentum_xu, momentum_xv;  // m²/s of both components of R v that flux_x carries
    Values momentum_yu, momentum_yv;  // that flux_y carries
};
template <class Visit, class... States>
constexpr void each_layer(Visit&& visit, States&... u) {
    visit("depth", u.depth...);
    visit("rolling", u.rolling...);
    visit("velocity_x", u.velocity_x...);
    visit("velocity_y", u.velocity_y...);
}
template <class Visit, class... States>
constexpr void each_rate(Visit&& visit, States&... u) {
    visit("drop_x", u.drop_x...);
    visit("drop_y", u.drop_y...);
    visit("curvature_x", u.curvature_x...);
    visit("curvature_y", u.curvature_y...);
    visit("exchanged", u.exchanged...);
    visit("rolling_x", u.rolling_x...);
    visit("rolling_y", u.rolling_y...);
    visit("u_x", u.u_x...);
    visit("u_y", u.u_y...);
    visit("v_x", u.v_x...);
    visit("v_y", u.v_y...);
    visit("flux_x", u.flux_x...);
    visit("flux_y", u.flux_y...);
    visit("momentum_xu", u.momentum_xu...);
    visit("momentum_xv", u.momentum_xv...);
    visit("momentum_yu", u.momentum_yu...);
    visit("momentum_yv", u.momentum_yv...);
}

template <class Values>
struct Fields {
    RkState<Values> u0;  // the layers before the sub-step, and after it
    RkState<Values> u1;  // the predicted state at its end
};
// Visits all fields except the layers of u0, which belong to the world.
template <class Visit, class... Lists>
void each_field(Visit&& visit, Lists&... f) {
    each_rate(with_prefix("u0.", visit), f.u0...);
    each_layer(with_prefix("u1.", visit), f.u1...);
    each_rate(with_prefix("u1.", visit), f.u1...);
}

static_assert(members_visited<RkState<char>>([](auto visit, auto& u) {
                  each_layer(visit, u), each_rate(visit, u);
              }) == sizeof(RkState<char>));

template <class Scalar>
using StateRows = RkState<Rows<Scalar>>;

// What the stages read and write: rows of the fields, and values that all vertices share.
template <class Scalar>
struct StageRows : Fields<Rows<Scalar>>, WorldRows<Constants<Scalar>, Scalar> {
    Rows<Scalar> first_slope, first_depth;
};

}  // namespace sim::inertial
