#pragma once

#include <cstdint>

#include "sim/momentum/forces.h"
#include "sim/momentum/friction.h"
#include "sim/momentum/ground.h"
#include "sim/momentum/water.h"

// Which material of bcre-inertial comes to rest and which starts, after transport.
//
// *Held*: friction at rest is at least gravity and pressure, G |∇z|ₛ ≤ μ(h) g cos θ. *Quiet*: nothing rolls; or
// the rolling layer is held and slower than .2 m/s; or it is thinner than freeze_depth, which no flow of granules is.
//
//     freeze   a vertex that is quiet, with its four neighbours, joins the standing layer
//     start    what would not be held at the thickness that starts, by a margin of 5 %, and
//              loose:    lies above d₀, S_z > loose_slope              all of it starts
//              natural:  min(S_z, S_h) > max(start_slope, anchor_gain S₀ + anchor_margin + anchor_step/2Δx)
//                                                                      up to start_depth, and what is loose; with
//                                                                      weather at most d − B, the slab
//
// S_z is the slope of the surface z = b + d + R, S_h that of the standing layer h = b + d. Without the neighbours
// a front, thin at its tip, would freeze and start again for ever; without "held", so would a deposit. Natural
// ground is judged by h too, or the weight of a front alone would break it. It starts under a flow as well, or a
// pour would roll over its own heap.
//
// Forest and nets hold a share H of what lies under them (world/things.h): they raise the slope at which natural ground
// fails toward tan 60°, and that of loose material toward 1.
//
// On wet ground the slopes at which ground starts, and its friction, are f times as large (water.h), before forest and
// nets raise them.
//
// Natural ground is stronger: a vertex that was steep from the start must become even steeper. anchor_step is a
// height, independent of the cell: an avalanche leaves a scarp of some metres beside a vertex, whose slope
// increases as the grid gets finer. Without it one scarp would trigger the next across a whole face.

namespace sim::momentum {

inline constexpr float kNearlyAtRest = 0.2f;                       // m/s
inline constexpr float kStartMargin = 0.95f;                       // of the driving force
inline constexpr float kHeldNatural = 1.7320508f, kHeldLoose = 1;  // slopes at which what is held starts

// Rows y = 0 … ny-1. Reads d, exchanged, held and the layers after transport; writes moved_depth and quiet.
template <class Number, class S = Scalar<Number>>
auto find_quiet(const StageRows<S>& w, Fields<Rows<S>>& to, int y) {
    return [c = w.c, depth = w.u0.depth[y], exchanged = w.exchanged[y], held = w.held[y],
            rolling = w.moved_rolling[y], from_u = w.moved_u[y], from_v = w.moved_v[y],
            to_depth = to.moved_depth[y], to_quiet = to.quiet[y]](int i) {
        store<Number>(at<Number>(depth, i) - at<Number>(exchanged, i), to_depth + i);
        const Number r = at<Number>(rolling, i), u = at<Number>(from_u, i), v = at<Number>(from_v, i);
        const auto stands = at<Number>(held, i) > S{0} && u * u + v * v < S(kNearlyAtRest * kNearlyAtRest);
        store(select(r < c.freeze_depth || stands || r <= S{0}, Number(1), Number(0)), to_quiet + i);
    };
}
// Beyond the border all is quiet. Rows y = -1 … ny.
template <class Number, class S = Scalar<Number>>
void end_quiet(const StageRows<S>& w, Fields<Rows<S>>& to, int y, Span x) {
    if (w.is_ground(y))
        to.quiet[y][-1] = to.quiet[y][w.nx] = 1;
    else
        std::fill(to.quiet[y] + x.first, to.quiet[y] + x.last, S{1});
}

// Rows y = 0 … ny-1. Reads the layers after transport, quiet, s, first_slope and first_depth, of a world with things
// also hold, net_depth, water, floor and walls; writes d, R and
// velocity of u0, up to vertex `end`. `active`, if given, has one byte per vector of lanes, which is set if
// anything rolled or rolls.
template <class Number, bool has_things = false, class S = Scalar<Number>>
auto yield(const StageRows<S>& w, LayerRows<S>& u0, int y, int end, std::uint8_t* active = nullptr) {
    return
        [c = w.c, ground = ground_rows(w, w.moved_depth, y), smooth = ground_rows(w, w.smooth_depth, y),
         walls = wall_rows<has_things>(w, y), hold = thing_row<has_things>(w.things.hold, y),
         nets = thing_row<has_things>(w.things.net_depth, y),
         water = thing_row<has_things>(w.things.water, y), below = thing_row<has_things>(w.things.floor, y),
         rolling = around(w.moved_rolling, y), quiet = around(w.quiet, y), from_u = w.moved_u[y],
         from_v = w.moved_v[y], first_slope = w.first_slope[y], first_depth = w.first_depth[y],
         depth = u0.depth[y], to_rolling = u0.rolling[y], to_u = u0.velocity_x[y], to_v = u0.velocity_y[y],
         end, active](int i) {
            const Number none(0), d = at<Number>(ground.here.depth, i), r = at<Number>(rolling.here, i);
            const Number had = at<Number>(to_rolling, i);
            Number free = d;
            if constexpr (has_things) free = max(d - at<Number>(below, i), none);
            const Number loose = max(d - at<Number>(first_depth, i), none),
                         slab = min(free, Number(c.start_depth));
            const Gradient<Number> h = gradient<Number>(ground, i, c);
            const Gradient<Number> z =
                driving_gradient<Number>(ground, rolling, i, Number(r + max(loose, slab)), none, none, c,
                                         walls_around<has_things, Number>(walls, ground, i, r, none, none));
            const Number steep = z.squared();
            Number holds =
                max(c.anchor_gain * at<Number>(first_slope, i) + c.anchor_margin, Number(c.start_slope));
            Number loose_slope(c.loose_slope);
            if constexpr (has_things) {
                const Number share = effective_share<Number>(water, i, c);
                holds *= share, loose_slope *= share;
                const Number net = at<Number>(nets, i);
                const Number held = select(net > S{0} && d <= net, Number(1), at<Number>(hold, i));
                if (any(held > S{0})) {
                    holds += held * max(S(kHeldNatural) - holds, none);
                    loose_slope += held * max(S(kHeldLoose) - loose_slope, none);
                }
            }
            const Number loose_holds = min(holds, loose_slope);
            const auto natural = min(steep, h.squared()) > holds * holds;
            const auto lies_loose = loose > S{0} && loose + r >= c.freeze_depth;
            const auto too_steep =
                (natural || (lies_loose && steep > loose_holds * loose_holds)) && d + r >= c.freeze_depth;

            Number moved = none;
            if (any(max(r, had) > S{0})) {
                const Number around_quiet = (at<Number>(quiet.here, i - 1) + at<Number>(quiet.here, i + 1)) +
                                            (at<Number>(quiet.south, i) + at<Number>(quiet.north, i));
                const auto freezes = at<Number>(quiet.here, i) + around_quiet > S(4.5);
                moved = select(freezes, -r, none);
            }
            if (any_before(end - i, too_steep)) {
                const Number can = select(natural, max(loose, slab), loose);
                const Gradient<Number> b = gradient<Number>(smooth, i, c);
                const Number cos = cosine_of(b);
                Number friction = friction_at_rest(Number((r + can) * cos), cos, c) * (cos * S(kGravity));
                if constexpr (has_things) friction *= effective_share<Number>(water, i, c);
                const auto goes =
                    drive_squared(b, z, S(kGravity * kStartMargin)) > friction * friction && can > S{0};
                moved = select(too_steep && goes, can, moved);
            }
            const Number rolls = r + moved;
            const auto left = rolls > S{0};
            // What starts is at rest.
            const Number kept = select(moved > S{0}, r / select(left, rolls, Number(1)), Number(1));
            if (active && any_before(end - i, max(max(had, r), rolls) > S{0}))
                active[static_cast<unsigned>(i) / kLanes<Number>] = 1;
            store_before<Number>(end, d - moved, depth, i);
            store_before(end, rolls, to_rolling, i);
            store_before<Number>(end, select(left, at<Number>(from_u, i) * kept, none), to_u, i);
            store_before<Number>(end, select(left, at<Number>(from_v, i) * kept, none), to_v, i);
        };
}

}  // namespace sim::momentum
