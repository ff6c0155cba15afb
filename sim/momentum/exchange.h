#pragma once

#include "sim/momentum/fields.h"
#include "sim/momentum/forces.h"
#include "sim/momentum/friction.h"
#include "sim/momentum/ground.h"
#include "sim/momentum/walls.h"
#include "sim/momentum/water.h"

// Exchange between the layers of bcre-inertial, after the forces. S = |∇(b + d)| is the slope of the standing
// ground, without the rolling layer, whose face would otherwise erode the more, the finer the grid.
//
//     S > s_ero:  Γ = +k |v| (S − s_ero) max(0, R − R_ero)/R       at most d, and half of R in a sub-step;
//                                                                  with weather at most d − B, the slab
//     S < μ(h):   Γ = −γ R (μ(h) − S) max(0, 1 − |v|/v_dep)
//
// A forest catches snow (Feistl et al. 2014, here with the speed as its measure):
//
//     Γ −= K/(ρ max(|v|, 1 m/s))                              at most a fifth of R in a sub-step
//
// On wet ground s_ero and μ(h) are f times as large (water.h).
//
// Erosion goes with speed: a rate that goes with thickness alone brakes like 1/τ at any speed. As drag it equals
// ξ = g/(k (S − s_ero)). What is eroded joins at rest, v ← v R/(R + ΔR); what is deposited takes its momentum
// along, so that the rest keeps its speed.

namespace sim::momentum {

inline constexpr float kMostCaught = 0.2f;  // of R

// Rows y = 0 … ny-1. Reads b, d, R and cosine, of a world with things also detrain, water, floor and walls; writes exchanged and fed,
// both in whole quanta, and slows driven_u and driven_v.
template <class Number, bool has_things = false, class S = Scalar<Number>>
auto exchange(const StageRows<S>& w, Fields<Rows<S>>& to, int y) {
    return [c = w.c, ground = ground_rows(w, w.u0.depth, y), rolling = w.u0.rolling[y], cosine = w.cosine[y],
            walls = wall_rows<has_things>(w, y), detrain = thing_row<has_things>(w.things.detrain, y),
            water = thing_row<has_things>(w.things.water, y),
            below = thing_row<has_things>(w.things.floor, y), to_u = to.driven_u[y], to_v = to.driven_v[y],
            to_exchanged = to.exchanged[y], to_fed = to.fed[y]](int i) {
        const Number none(0), r = at<Number>(rolling, i);
        const Number u = at<Number>(to_u, i), v = at<Number>(to_v, i), squared = u * u + v * v;
        const auto moves = squared > S{0};
        if (!any(moves)) {
            store(none, to_exchanged + i), store(r, to_fed + i);
            return;
        }
        const Number speed = sqrt(squared), d = at<Number>(ground.here.depth, i);
        const Number slope = sqrt(Number(gradient_beside<has_things, Number>(ground, i, walls, c).squared()));

        Number erodes(c.erosion_slope);
        if constexpr (has_things) erodes *= effective_share<Number>(water, i, c);
        Number free = d;
        if constexpr (has_things) free = max(d - at<Number>(below, i), none);
        const Number steep = max(slope - erodes, none), above = max(r - c.erosion_depth, none);
        Number change = none;
        if (any(steep * above > S{0})) {
            const Number wanted = (c.eroded_per_speed * speed) * (steep * above / max(r, Number(S(1e-12))));
            change = min(min(wanted, free), S(0.5) * r);
        }
        const Number slow = max(Number(1) - speed * c.per_deposit_speed, none);
        if (any(slow > S{0})) {
            const Number cos = at<Number>(cosine, i);
            Number friction = friction_at_rest(Number(r * cos), cos, c);
            if constexpr (has_things) friction *= effective_share<Number>(water, i, c);
            const Number flat = max(friction - slope, none);
            change -= min(c.deposit_pace * r * (flat * slow), r);
        }
        if constexpr (has_things) {
            const Number pull = at<Number>(detrain, i);
            if (any(pull > S{0})) change -= min(c.caught * pull / max(speed, Number(1)), S(kMostCaught) * r);
        }
        const Number whole =
            with_its_sign(change, [&](const Number& size) { return in_quanta(size, c.dither); });
        const Number exchanged = select(moves, min(max(whole, -r), free), none);
        const Number fed = r + exchanged;
        const auto feeds = exchanged > S{0};
        const Number kept = select(feeds, r / select(feeds, fed, Number(1)), Number(1));
        store(exchanged, to_exchanged + i), store(fed, to_fed + i);
        store<Number>(u * kept, to_u + i), store<Number>(v * kept, to_v + i);
    };
}
template <class Number, class S = Scalar<Number>>
void end_exchange(const StageRows<S>& w, Fields<Rows<S>>& to, int y, Span x) {
    end_mirrored<Number>(w, to.fed, S{1}, S{1}, y, x);
}

}  // namespace sim::momentum
