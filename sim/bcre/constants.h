#pragma once

#include <algorithm>

#include "sim/simd/exponential.h"
#include "sim/world/params.h"
#include "sim/world/quanta.h"

namespace sim::bcre {

inline constexpr double kLittle = 0.133;  // e^kGrowsLittle − 1

// γ R Δt/Δx up to which the exchange of a sub-step hardly changes the slope that drives it.
inline constexpr double kWeakExchange = 0.2;

// Constants of a sub-step, computed from parameters, cell size and sub-step. They are the same for all
// vertices. `slope_dx` is a slope times Δx: the drop over a cell.
template <class Scalar>
struct Constants {
    Scalar courant;                 // Δt/Δx, s/m
    Dither<Scalar> dither;          // of the sub-step
    bool outflow_may_exceed_layer;  // at this Courant number the outflow of a peak may exceed its layer
    Scalar greatest_outflow;        // muscl: per R of both states, to all sides (flux_muscl.h)

    Law law;
    Scalar rolling_speed, half_shear_rate, speed_per_slope_dx, max_speed;

    Scalar growth_per_slope_dx;  // γ Δt/Δx
    Scalar growth_at_level;      // γ Δt s_stop
    Scalar room_per_growth;      // Δx / (κ γ Δt), m
    Scalar strong_pace;          // γ κ Δt/Δx, 1/m
    Scalar exchange_depth;       // R_c, m
    Scalar rate_depth;           // R_c, or less: the layer from which a rate takes S to the threshold, m
    Scalar thick_exchange;       // m per growth, for a layer thicker than exchange_depth
    Scalar little_per_rolling;   // 1/m: kLittle / the layer above which the exponential no longer holds

    Scalar start_slope_dx, start_depth, freeze_depth;  // m
};

template <class Scalar>
Constants<Scalar> constants_of(const Params& p, float cell, Substep<Scalar> sub) {
    constexpr Scalar kSpread = Scalar(1.41421356237309505);                               // κ
    constexpr Scalar kNotZero = Scalar(1e-30);                                            // if the rate is 0
    constexpr Scalar kPeakGives = Scalar(2 * 1.41421356237309505), kMost = Scalar(0.75);  // times R
    constexpr Scalar kMostGiven = Scalar(1.5 * 1.0001);                                   // and for rounding
    const Scalar dx = cell, courant = sub.dt / dx, growth = p.exchange_rate * sub.dt;
    const Scalar speed = p.law == Law::kConstant ? p.rolling_speed : p.max_speed;
    const Scalar weak = Scalar(kWeakExchange) / std::max(growth / dx, kNotZero);
    const bool decays_much = growth * p.stop_slope > Scalar(kExpm1Small);  // on level ground
    const Scalar room = dx / (kSpread * std::max(growth, kNotZero));
    const Scalar strong_pace = growth * kSpread / dx;
    const Scalar thick_share = -sim::expm1(Scalar(-strong_pace * p.exchange_depth));  // 1 − e^…
    return {.courant = courant,
            .dither = {sub.dither},
            .outflow_may_exceed_layer = kPeakGives * courant * speed > kMost,
            .greatest_outflow = kMostGiven * courant * speed,
            .law = p.law,
            .rolling_speed = p.rolling_speed,
            .half_shear_rate = p.shear_rate / 2,
            .speed_per_slope_dx = p.speed_per_slope / dx,
            .max_speed = p.max_speed,
            .growth_per_slope_dx = growth / dx,
            .growth_at_level = growth * p.stop_slope,
            .room_per_growth = room,
            .strong_pace = strong_pace,
            .exchange_depth = p.exchange_depth,
            .rate_depth = std::min(room, Scalar{p.exchange_depth}),
            .thick_exchange = p.exchange_depth < weak ? Scalar{p.exchange_depth} : room * thick_share,
            .little_per_rolling =
                decays_much ? Scalar(1e30) : Scalar(kLittle) / std::min(weak, Scalar{p.exchange_depth}),
            .start_slope_dx = p.start_slope * dx,
            .start_depth = nearest_quanta(Scalar{p.start_depth}),
            .freeze_depth = p.freeze_depth};
}

}  // namespace sim::bcre
