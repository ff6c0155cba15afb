#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "sim/simd/rows.h"
#include "sim/stages/field_list.h"
#include "sim/stages/world_rows.h"
#include "sim/world/params.h"
#include "sim/world/quanta.h"

// The constants and fields that the stages of the models with momentum work on: the only list of them.
// `voellmy` is forces and transport; `bcre-inertial` adds exchange between the layers, start and rest.

namespace sim::momentum {

// A layer this thin, ten quanta, does not move: rounding at four faces could take more than it has. m
template <class Number>
inline constexpr Scalar<Number> kThin = kHasQuanta<Number> ? 10 * kQuantum : 1e-12f;

// Constants of a sub-step, computed from parameters, cell size and sub-step. They are the same for all
// vertices. Each stage copies them for each row; whole cache lines are copied faster.
template <class Scalar>
struct alignas(64) Constants {
    Scalar courant;           // Δt/Δx, s/m
    Dither<Scalar> dither;    // of the sub-step
    Scalar per_two_cells;     // 1/2Δx, 1/m
    Scalar per_four_squares;  // 1/4Δx², 1/m²

    Scalar time, fall;      // Δt, s; g Δt, m/s
    Scalar friction;        // μ of a thick layer
    Scalar friction_more;   // μ_thin − μ; 0 in voellmy
    Scalar per_fold_depth;  // 1/m
    Scalar drag_length;     // g Δt/ξ, s: drag takes |v| times this, over the thickness normal to the slope
    int drag_eighths;       // 8 p
    Scalar fluidization, cohesion, per_cohesion_depth;  // f; 1 − μ; 1/h_c, 1/m, or 0
    Scalar greatest_speed;                              // m/s, in plan
    Scalar levelling;                                   // ½ of it (transport.h)
    Scalar held_rise;  // μ Δx, m: rise of the surface over a cell at which friction holds a layer

    // bcre-inertial only.
    Scalar eroded_per_speed, erosion_slope, erosion_depth;  // k Δt, s; 1; m
    Scalar deposit_pace, per_deposit_speed;                 // γ Δt; s/m
    Scalar start_slope, loose_slope, start_depth, freeze_depth, anchor_gain, anchor_margin;

    // Of what stands in a world (world/things.h).
    Scalar stem_drag;  // ½ C_d Δt, s: drag takes |v|ₛ times this and A
    Scalar caught;     // Δt/ρ, m³ s/kg; 0 if ρ is unknown
    Scalar buoyancy;   // ρ_w/ρ, at most 1; 0 if ρ is unknown (water.h)
};

inline constexpr double kStemDrag = 1.5;  // C_d

template <class Scalar>
Constants<Scalar> constants_of(const Params& p, float cell, Substep<Scalar> sub) {
    const Scalar dx = cell;
    const bool exchanges = p.model == Model::kBcreInertial;
    return {.courant = sub.dt / dx,
            .dither = {sub.dither},
            .per_two_cells = 1 / (2 * dx),
            .per_four_squares = 1 / (4 * dx * dx),
            .time = sub.dt,
            .fall = Scalar(kGravity) * sub.dt,
            .friction = p.friction,
            .friction_more = exchanges ? Scalar{p.friction_thin} - Scalar{p.friction} : Scalar{0},
            .per_fold_depth = 1 / Scalar{p.friction_fold_depth},
            .drag_length = Scalar(kGravity) * sub.dt / Scalar{p.drag},
            .drag_eighths = static_cast<int>(std::lround(8 * p.drag_exponent)),
            .fluidization = p.fluidization,
            .cohesion = 1 - p.friction,
            .per_cohesion_depth = p.cohesion_depth > 0 ? 1 / Scalar{p.cohesion_depth} : Scalar{0},
            .greatest_speed = p.greatest_speed,
            .levelling = Scalar(0.5) * p.levelling,
            .held_rise = p.friction * dx,
            .eroded_per_speed = p.erosion_rate * sub.dt,
            .erosion_slope = p.erosion_slope,
            .erosion_depth = p.erosion_depth,
            .deposit_pace = p.deposit_rate * sub.dt,
            .per_deposit_speed = 1 / Scalar{p.deposit_speed},
            .start_slope = p.start_slope,
            .loose_slope = p.loose_slope,
            .start_depth = nearest_quanta(Scalar{p.start_depth}),
            .freeze_depth = p.freeze_depth,
            .anchor_gain = p.anchor_gain,
            .anchor_margin = p.anchor_margin + p.anchor_step / (2 * dx),
            .stem_drag = Scalar(0.5 * kStemDrag) * sub.dt,
            .caught = p.density > 0 ? sub.dt / Scalar{p.density} : Scalar{0},
            .buoyancy =
                p.density > 0 ? std::min(Scalar(kWaterDensity) / Scalar{p.density}, Scalar{1}) : Scalar{0}};
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
    Values slope_x, slope_y, cosine;  // gradient B of the smoothed ground, and cos θ = 1/√(1 + |B|²)
    Values surface_x, surface_y;  // half of the limited slopes of b + d + R over a cell, m; with levelling
    Values driven_u, driven_v;    // velocity after the forces and the exchange of the sub-step, m/s
    Values held;                  // 1 where friction holds the layer at rest, else 0
    Values exchanged;             // m that the standing layer loses, a deposit negative
    Values fed;                   // R after that, m
    // At half of the sub-step, by transport alone; and half of the limited slopes over a cell, along x and y.
    Values mid_rolling, mid_u, mid_v;  // m, m/s
    Values rolling_x, u_x, v_x;
    Values rolling_y, u_y, v_y;
    Values flux_x, flux_y;                                  // m through each face, to the east, to the north
    Values leaving_xu, leaving_xv, leaving_yu, leaving_yv;  // velocity of that flux where it comes from, m/s
    Values turned_xu, turned_xv, turned_yu, turned_yv;      // the same on the ground where it arrives
    Values share;  // the share of its wanted outflow that a vertex can give
    Values moved_depth, moved_rolling, moved_u, moved_v;  // the layers after transport, m, m/s
    Values quiet;  // 1 where the rolling layer may come to rest, else 0
};
template <class Visit, class... Lists>
constexpr void each_field(Visit&& visit, Lists&... f) {
    visit("slope_x", f.slope_x...);
    visit("slope_y", f.slope_y...);
    visit("cosine", f.cosine...);
    visit("surface_x", f.surface_x...);
    visit("surface_y", f.surface_y...);
    visit("driven_u", f.driven_u...);
    visit("driven_v", f.driven_v...);
    visit("held", f.held...);
    visit("exchanged", f.exchanged...);
    visit("fed", f.fed...);
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
    visit("moved_depth", f.moved_depth...);
    visit("moved_rolling", f.moved_rolling...);
    visit("moved_u", f.moved_u...);
    visit("moved_v", f.moved_v...);
    visit("quiet", f.quiet...);
}
static_assert(members_visited<Fields<char>>([](auto visit, auto& f) { each_field(visit, f); }) ==
              sizeof(Fields<char>));

// What stands in a world, as the stages read it (world/things.h).
template <class Scalar>
struct ThingRows {
    Rows<Scalar> natural, drag, detrain, hold, net_depth, wall_x, wall_y, water;
    Rows<Scalar> floor;  // m of d that a flow leaves alone: the snow below a weak layer (world/weather.h)
};

template <class Scalar>
using LayerRows = MovingLayers<Rows<Scalar>>;

// What the stages read and write: rows of the fields, and values that all vertices share.
template <class Scalar>
struct StageRows : Fields<Rows<Scalar>>, WorldRows<Constants<Scalar>, Scalar> {
    LayerRows<Scalar> u0;
    Rows<Scalar> smooth_depth, first_slope, first_depth;
    ThingRows<Scalar> things;  // only of a world that has any

    // Without exchange, transport takes the layers of the world and writes them again.
    void exchange_nothing() {
        this->fed = u0.rolling;
        this->moved_rolling = u0.rolling, this->moved_u = u0.velocity_x, this->moved_v = u0.velocity_y;
    }
    // The layers after transport, as layers.
    LayerRows<Scalar> moved() const {
        return {this->moved_depth, this->moved_rolling, this->moved_u, this->moved_v};
    }
};

}  // namespace sim::momentum
