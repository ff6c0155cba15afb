#pragma once

#include "sim/bcre/constants.h"
#include "sim/stages/slope.h"

// Velocity of the rolling layer in `bcre`: from a vertex to each of its lower neighbours, in proportion to
// the drop, at the speed of a law. It depends on the ground, and is defined even where nothing rolls. It has
// no inertia.
//
//             N              v_E = k max(0, D_E),  k = V / |f|   toward east; the same for W, N and S
//             ↑
//         W ← C → E          (C)  V = v₀                         one speed
//             ↓              (HK) V = min(v_max, k_v S)          Hadeler and Kuttler 1999
//             S              (T)  V = min(v_max, v₀ + ½ γ̇ R)     mean speed of a layer with shear rate γ̇
//
// On a slope two of the four are not 0; they are the components of a vector of length V. On a ridge material
// leaves to both sides, and in a pit it stays. D and f come from slope.h, so flow and exchange agree on the
// downhill direction.
//
// muscl uses second order, v = −V g/|g| from central differences, g = ((h_E − h_W), (h_N − h_S)) / 2. (Drops
// with a curvature correction are second order too, but they pass grid-scale noise of h on to ∇·v.)

namespace sim::bcre {

template <class Number>
struct Vector {
    Number x, y;
};

template <class Number>
[[gnu::always_inline]] inline Number law_speed(const Number& slope_dx, const Number& rolling,
                                               const Constants<Scalar<Number>>& c) {
    switch (c.law) {
        case Law::kConstant:
            break;
        case Law::kSlope:
            return min(slope_dx * c.speed_per_slope_dx, Number(c.max_speed));
        case Law::kShear:
            return min(rolling * c.half_shear_rate + c.rolling_speed, Number(c.max_speed));
    }
    return Number(c.rolling_speed);
}

// The least slope_dx, m, with which the pace is computed on level ground.
template <class Number>
inline constexpr auto kFlat = Scalar<Number>(1e-12);

// k, the pace: speed per drop, 1/s. On level ground nothing moves, and the pace only has to be finite.
template <class Number>
[[gnu::always_inline]] inline Number pace_of(const Number& slope_dx, const Number& rolling,
                                             const Constants<Scalar<Number>>& c) {
    return law_speed(slope_dx, rolling, c) / max(slope_dx, Number(kFlat<Number>));
}

// The net velocity, from the motion to opposite sides.
template <class Number>
[[gnu::always_inline]] inline Vector<Number> net_velocity(const Drops<Number>& drop, const Number& pace) {
    const Number none(0);
    return {(max(drop.east, none) - max(drop.west, none)) * pace,
            (max(drop.north, none) - max(drop.south, none)) * pace};
}

// Velocity for muscl. `fall_x` = h_W − h_E and `fall_y` = h_S − h_N are drops over two cells, m.
template <class Number>
[[gnu::always_inline]] inline Vector<Number> central_velocity(const Number& fall_x, const Number& fall_y,
                                                              const Number& rolling,
                                                              const Constants<Scalar<Number>>& c) {
    const Number twice = sqrt(fall_x * fall_x + fall_y * fall_y);
    const Number pace =
        law_speed(twice * Scalar<Number>(0.5), rolling, c) / max(twice, Number(2 * kFlat<Number>));
    return {pace * fall_x, pace * fall_y};
}

}  // namespace sim::bcre
