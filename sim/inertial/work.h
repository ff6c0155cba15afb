#pragma once

#include <array>

#include "sim/simd/exponential.h"
#include "sim/simd/rows.h"
#include "sim/world/params.h"
#include "sim/world/quanta.h"

// What the stages of a sub-step of `bcre-inertial` work with: numbers, and rows (rows.h).

namespace sim::inertial {

// Thinner than this a layer is none, m; a quantum is 7.6e-6.
inline constexpr float kNothing = 1e-12f;

// What the formulas take from parameters, cell and sub-step: the same for all vertices.
template <class Scalar>
struct Constants {
    Scalar courant;         // Δt/Δx, s/m
    Dither<Scalar> dither;  // of the sub-step
    Scalar dx, per_cell;    // m, 1/m

    Scalar speed_per_slope, max_speed, half_speed_depth;
    Scalar nearly_capped_squared;  // of a slope, a hair below the one that makes it as fast as may be
    Scalar relaxed;                // share of the way to the terminal velocity in half a sub-step

    Scalar pace;  // γ Δt
    Scalar exchange_depth, stop_slope_thick, stop_slope_more, per_fold_depth;
    Scalar greatest_stop_slope;  // a hair above what any layer stops at
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

// A state of the layers, and what it leads to. A face lies west (x) or south (y) of its vertex.
template <class Scalar>
struct Level {
    Rows<Scalar> depth, rolling, velocity_x, velocity_y;  // m, m/s
    Rows<Scalar> drop_x, drop_y;            // m through each face, that h falls to the east, to the north
    Rows<Scalar> curvature_x, curvature_y;  // what makes a drop of second order, m
    Rows<Scalar> exchanged;                 // m in the sub-step, erosion positive
    Rows<Scalar> rolling_x, u_x, v_x;  // half of the limited slope of R and velocity along x, over a cell
    Rows<Scalar> rolling_y, u_y, v_y;  // along y
    Rows<Scalar> flux_x, flux_y;       // m through each face in the sub-step, to the east, to the north
    Rows<Scalar> momentum_xu, momentum_xv;  // m²/s that flux_x takes along of both components of R v
    Rows<Scalar> momentum_yu, momentum_yv;  // flux_y
};

template <class Scalar>
struct Work {
    int nx, ny;
    std::array<Border, 4> borders;  // by Side
    Constants<Scalar> c;
    Rows<Scalar> bedrock, first_slope, first_depth;
    Level<Scalar> now;   // as the sub-step finds the layers, and leaves them
    Level<Scalar> then;  // where they would be at its end

    bool is_ground(int y) const { return y >= 0 && y < ny; }
    bool is_wall(Side side) const { return borders[side] == Border::kWall; }
};

}  // namespace sim::inertial
