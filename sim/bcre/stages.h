#pragma once

#include <algorithm>
#include <cstdint>

#include "sim/bcre/exchange.h"
#include "sim/bcre/fields.h"
#include "sim/bcre/flux_lax_friedrichs.h"
#include "sim/bcre/flux_local_lax_friedrichs.h"
#include "sim/bcre/flux_muscl.h"
#include "sim/bcre/runge_kutta.h"
#include "sim/bcre/velocity.h"
#include "sim/bcre/yield.h"
#include "sim/stages/stages.h"

// The stages of `bcre` in call order. They follow halo and drops (sim/stages/stages.h).

namespace sim::bcre {

// Rows y = 0 … ny-1. Reads drop_x, drop_y; writes slope_dx.
template <class Number, class S = Scalar<Number>>
auto find_slope_dx(const StateRows<S>& u, Rows<S>& to, int y) {
    return [drop_x = u.drop_x[y], south = u.drop_y[y], north = u.drop_y[y + 1], slope_dx = to[y]](int i) {
        store(slope_dx_of(outward<Number>(drop_x, south, north, i)), slope_dx + i);
    };
}

// Rows y = 0 … ny-1. Reads drop_x, drop_y, curvature_x, curvature_y; writes slope_dx.
template <class Number, class S = Scalar<Number>>
auto find_limited_slope_dx(const StateRows<S>& u, Rows<S>& to, int y) {
    return [drop_x = u.drop_x[y], south = u.drop_y[y], north = u.drop_y[y + 1],
            curvature_x = u.curvature_x[y], curvature_south = u.curvature_y[y],
            curvature_north = u.curvature_y[y + 1], slope_dx = to[y]](int i) {
        const Drops<Number> drop = outward<Number>(drop_x, south, north, i);
        store(slope_dx_of<Number>(
                  {drop.east + at<Number>(curvature_x, i + 1), drop.west + at<Number>(curvature_x, i),
                   drop.north + at<Number>(curvature_north, i), drop.south + at<Number>(curvature_south, i)}),
              slope_dx + i);
    };
}

// The sum of all outflows of vertex i through its faces: Σ max(0, outward).
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Number sum_outward(const S* in_x, const S* south, const S* north, int i) {
    const Number none(0);
    return (max(at<Number>(in_x, i + 1), none) - min(at<Number>(in_x, i), none)) +
           (max(at<Number>(north, i), none) - min(at<Number>(south, i), none));
}

// local-lax-friedrichs, rows y = 0 … ny-1. Reads R, drop_x, drop_y, slope_dx; writes outflow.
template <class Number, class S = Scalar<Number>>
auto find_outflow(const StageRows<S>& w, Rows<S>& to, int y) {
    return [c = w.c, rolling = w.u0.rolling[y], slope_dx = w.u0.slope_dx[y], drop_x = w.u0.drop_x[y],
            south = w.u0.drop_y[y], north = w.u0.drop_y[y + 1], outflow = to[y]](int i) {
        const Number r = at<Number>(rolling, i);
        const Number wanted = outflow_per_drop(r, pace_of(at<Number>(slope_dx, i), r, c), c);
        if (c.outflow_may_exceed_layer) {
            const Number all = wanted * sum_outward<Number>(drop_x, south, north, i);
            store<Number>(wanted * outflow_share(all, r), outflow + i);
        } else {
            store(wanted, outflow + i);
        }
    };
}
// Nothing leaves the halo: rows y = -1 … ny.
template <class Number, class S = Scalar<Number>>
void end_outflow(const StageRows<S>& w, Rows<S>& outflow, StateRows<S>& u, int y, Span x) {
    for (S* row : {outflow[y], u.velocity_x[y], u.velocity_y[y]}) {
        if (w.is_ground(y))
            row[-1] = row[w.nx] = 0;
        else
            std::fill(row + x.first, row + x.last, S{0});
    }
}
// Then faces y = 0 … ny. Reads drop_x, drop_y, outflow; writes flux_x, flux_y, in whole quanta.
template <class Number, class S = Scalar<Number>>
auto find_split_fluxes(const StageRows<S>& w, Rows<S>& to_x, Rows<S>& to_y, int y) {
    return [c = w.c, drop_x = w.u0.drop_x[y], drop_y = w.u0.drop_y[y], outflow = w.outflow[y],
            south = w.outflow[y - 1], flux_x = to_x[y], flux_y = to_y[y]](int i) {
        const Number here = at<Number>(outflow, i), west = at<Number>(outflow, i - 1);
        const Number in_x = flux_local_lax_friedrichs(at<Number>(drop_x, i), west, here);
        const Number in_y = flux_local_lax_friedrichs(at<Number>(drop_y, i), at<Number>(south, i), here);
        store(quantised(in_x, c), flux_x + i);
        store(quantised(in_y, c), flux_y + i);
    };
}

// lax-friedrichs, rows y = 0 … ny-1. Reads R, drop_x, drop_y, slope_dx; writes outflow, velocity_x,
// velocity_y.
template <class Number, class S = Scalar<Number>>
auto find_quarter_outflow(const StageRows<S>& w, Rows<S>& to, StateRows<S>& u, int y) {
    return [c = w.c, rolling = w.u0.rolling[y], slope_dx = w.u0.slope_dx[y], drop_x = w.u0.drop_x[y],
            south = w.u0.drop_y[y], north = w.u0.drop_y[y + 1], outflow = to[y], more_x = u.velocity_x[y],
            more_y = u.velocity_y[y]](int i) {
        const Number r = at<Number>(rolling, i), pace = pace_of(at<Number>(slope_dx, i), r, c);
        const Quarters<Number> gives =
            quarters(r, net_velocity(outward<Number>(drop_x, south, north, i), pace), c);
        store(gives.quarter, outflow + i), store(gives.along_x, more_x + i), store(gives.along_y, more_y + i);
    };
}
// Then faces y = 0 … ny. Reads outflow, velocity_x, velocity_y; writes flux_x, flux_y, in whole quanta.
template <class Number, class S = Scalar<Number>>
auto find_quarter_fluxes(const StageRows<S>& w, Rows<S>& to_x, Rows<S>& to_y, int y) {
    return [c = w.c, outflow = w.outflow[y], given_south = w.outflow[y - 1], more_x = w.u0.velocity_x[y],
            more_y = w.u0.velocity_y[y], more_south = w.u0.velocity_y[y - 1], flux_x = to_x[y],
            flux_y = to_y[y]](int i) {
        const Number here = at<Number>(outflow, i), west = at<Number>(outflow, i - 1);
        const Number in_x = flux_lax_friedrichs(west, at<Number>(more_x, i - 1), here, at<Number>(more_x, i));
        const Number in_y = flux_lax_friedrichs(at<Number>(given_south, i), at<Number>(more_south, i), here,
                                                at<Number>(more_y, i));
        store(quantised(in_x, c), flux_x + i);
        store(quantised(in_y, c), flux_y + i);
    };
}

// muscl, rows y = 0 … ny-1. Reads R, drop_x, drop_y; writes velocity_x, velocity_y.
template <class Number, class S = Scalar<Number>>
auto find_central_velocity(const StageRows<S>& w, const StateRows<S>& from, Rows<S>& to_u, Rows<S>& to_v,
                           int y) {
    return [c = w.c, rolling = from.rolling[y], drop_x = from.drop_x[y], south = from.drop_y[y],
            north = from.drop_y[y + 1], u = to_u[y], v = to_v[y]](int i) {
        const Vector<Number> velocity =
            central_velocity<Number>(at<Number>(drop_x, i) + at<Number>(drop_x, i + 1),
                                     at<Number>(south, i) + at<Number>(north, i), at<Number>(rolling, i), c);
        store(velocity.x, u + i), store(velocity.y, v + i);
    };
}
// Beyond the border the velocity is that of the border.
template <class Number, class S = Scalar<Number>>
void end_velocity(const StageRows<S>& w, Rows<S>& velocity_x, int y) {
    S* u = velocity_x[y];
    u[-1] = u[0], u[w.nx] = u[w.nx - 1];
}
// Then faces y = 0 … ny. Reads R, velocity_x, velocity_y of a state; writes flux_x, flux_y, still unlimited:
// first those of u0, then the mean of those of u0 and u1.
template <class Number, RkStage stage, class S = Scalar<Number>>
auto find_muscl_fluxes(const StageRows<S>& w, Rows<S>& to_x, Rows<S>& to_y, int y) {
    constexpr bool kSecond = stage == RkStage::kSecond;
    const StateRows<S>& from = kSecond ? w.u1 : w.u0;
    return [c = w.c, r = from.rolling[y], r_south = from.rolling[y - 1],
            r_north = from.rolling[std::min(y + 1, w.ny)], r_south2 = from.rolling[std::max(y - 2, -1)],
            u = from.velocity_x[y], v = from.velocity_y[std::min(y, w.ny - 1)],
            v_south = from.velocity_y[std::max(y - 1, 0)], flux_x = to_x[y], flux_y = to_y[y]](int i) {
        const Number here = at<Number>(r, i);
        const Number in_x =
            flux_muscl<Number>({at<Number>(r, i - 2), at<Number>(r, i - 1), here, at<Number>(r, i + 1)},
                               at<Number>(u, i - 1), at<Number>(u, i), c);
        const Number in_y = flux_muscl<Number>(
            {at<Number>(r_south2, i), at<Number>(r_south, i), here, at<Number>(r_north, i)},
            at<Number>(v_south, i), at<Number>(v, i), c);
        store(kSecond ? mean(at<Number>(flux_x, i), in_x) : in_x, flux_x + i);
        store(kSecond ? mean(at<Number>(flux_y, i), in_y) : in_y, flux_y + i);
    };
}

// Nothing passes a wall. Faces y = 0 … ny.
template <class Number, class S = Scalar<Number>>
void close_walls(const StageRows<S>& w, Rows<S>& flux_x, Rows<S>& flux_y, int y, Span x) {
    if (w.is_wall(kWest)) flux_x[y][0] = 0;
    if (w.is_wall(kEast)) flux_x[y][w.nx] = 0;
    if ((y == 0 && w.is_wall(kSouth)) || (y == w.ny && w.is_wall(kNorth)))
        std::fill(flux_y[y] + x.first, flux_y[y] + x.last, S{0});
}

// The rolling layer at vertex i of a row after the fluxes have passed.
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Number carried_at(const S* rolling, const S* flux_x, const S* flux_south,
                                                const S* flux_north, int i) {
    return carried(at<Number>(rolling, i), at<Number>(flux_x, i), at<Number>(flux_x, i + 1),
                   at<Number>(flux_south, i), at<Number>(flux_north, i));
}

// muscl: the erosion of vertex i of a row at the rate of a state, m.
template <class Number, class S = Scalar<Number>>
[[gnu::always_inline]] inline Number exchanged_at(const S* depth, const S* rolling, const S* slope_dx, int i,
                                                  const Constants<S>& c) {
    return exchanged_at_rate(at<Number>(rolling, i), at<Number>(depth, i),
                             growth_of(at<Number>(slope_dx, i), c), c);
}

// muscl, rows y = 0 … ny-1. Predicts the state u1, unrounded, because only fluxes and exchange are computed
// from it. Reads d, R, slope_dx of u0, flux_x, flux_y; writes exchanged, and d, R of u1.
template <class Number, class S = Scalar<Number>>
auto predict(const StageRows<S>& w, Rows<S>& to, StateRows<S>& u1, int y) {
    return [c = w.c, depth = w.u0.depth[y], rolling = w.u0.rolling[y], slope_dx = w.u0.slope_dx[y],
            exchanged = to[y], flux_x = w.flux_x[y], south = w.flux_y[y], north = w.flux_y[y + 1],
            d = u1.depth[y], r = u1.rolling[y]](int i) {
        const Number taken = exchanged_at<Number>(depth, rolling, slope_dx, i, c);
        store(taken, exchanged + i);
        store(predicted_rolling(carried_at<Number>(rolling, flux_x, south, north, i), taken), r + i);
        store<Number>(at<Number>(depth, i) - taken, d + i);
    };
}

// muscl, rows y = 0 … ny-1. Reads R, flux_x, flux_y; writes share. Sets `less` if the outflow of a vertex may
// be limited. `less` needs a world of one material, because only there do the layers of both states bound the
// outflow (greatest_outflow).
template <class Number, class S = Scalar<Number>>
auto find_share(const StageRows<S>& w, Rows<S>& to, int y, bool* less = nullptr) {
    return [c = w.c, rolling = w.u0.rolling[y], next = w.u1.rolling[y], flux_x = w.flux_x[y],
            south = w.flux_y[y], north = w.flux_y[y + 1], share = to[y], less](int i) {
        const Number r = at<Number>(rolling, i);
        if (less && !any(greatest_outflow(r, at<Number>(next, i), c) > spare_of(r))) {
            store(Number(1), share + i);
            return;
        }
        store(outflow_share(sum_outward<Number>(flux_x, south, north, i), r), share + i);
        if (less) *less = true;
    };
}
// Nothing leaves the halo: rows y = -1 … ny.
template <class Number, class S = Scalar<Number>>
void end_share(const StageRows<S>& w, Rows<S>& to, int y, Span x) {
    S* share = to[y];
    if (w.is_ground(y))
        share[-1] = share[w.nx] = 0;
    else
        std::fill(share + x.first, share + x.last, S{0});
}
// Faces y = 0 … ny. Reads share; limits flux_x, flux_y to the layers of the vertices.
template <class Number, class S = Scalar<Number>>
auto share_fluxes(const StageRows<S>& w, Rows<S>& to_x, Rows<S>& to_y, int y) {
    return [share = w.share[y], share_south = w.share[y - 1], flux_x = to_x[y], flux_y = to_y[y]](int i) {
        const Number here = at<Number>(share, i), in_x = at<Number>(flux_x, i), in_y = at<Number>(flux_y, i);
        store<Number>(in_x * select(in_x > S{0}, at<Number>(share, i - 1), here), flux_x + i);
        store<Number>(in_y * select(in_y > S{0}, at<Number>(share_south, i), here), flux_y + i);
    };
}
// Rounds the fluxes to whole quanta. Faces y = 0 … ny.
template <class Number, class S = Scalar<Number>>
auto quantise_fluxes(const StageRows<S>& w, Rows<S>& to_x, Rows<S>& to_y, int y) {
    return [c = w.c, flux_x = to_x[y], flux_y = to_y[y]](int i) {
        store(quantised(at<Number>(flux_x, i), c), flux_x + i);
        store(quantised(at<Number>(flux_y, i), c), flux_y + i);
    };
}

// Rows y = 0 … ny-1: applies fluxes and exchange, then starts ground that is too steep and freezes layers
// that are too thin. Reads slope_dx and, for muscl, exchanged and the predicted state; writes d, R, up to
// vertex `end`. `active`, if given, has one byte per vector of lanes, which is set if anything moved or came
// to rest.
template <class Number, Scheme scheme, class S = Scalar<Number>>
auto settle(const StageRows<S>& w, StateRows<S>& u, int y, int end, std::uint8_t* active = nullptr) {
    constexpr bool kSecond = scheme == Scheme::kMuscl;
    return [c = w.c, depth = u.depth[y], rolling = u.rolling[y], flux_x = w.flux_x[y], south = w.flux_y[y],
            north = w.flux_y[y + 1], slopes = kSecond ? w.u1.slope_dx[y] : w.u0.slope_dx[y],
            taken = w.exchanged[y], then_depth = w.u1.depth[y], then_rolling = w.u1.rolling[y], end,
            active](int i) {
        const Number slope_dx = only_before(end, at<Number>(slopes, i), i);
        const Number carried = carried_at<Number>(rolling, flux_x, south, north, i);
        Number lies = at<Number>(depth, i), rolls = carried;
        if constexpr (kSecond) {
            const Number next = exchanged_at<Number>(then_depth, then_rolling, slopes, i, c);
            const Number wanted = mean(at<Number>(taken, i), next);
            transfer(max(in_quanta(wanted, c.dither), -carried), lies, rolls);
        } else {
            transfer(exchanged(carried, slope_dx, sim::expm1_small(growth_of(slope_dx, c)), c), lies, rolls);
        }
        bool moves = true;
        if (any(rolls < c.freeze_depth) || i + kLanes < Number >> end) {
            yield(slope_dx, lies, rolls, c);
            moves = any_before(end - i, carried > S{0} || rolls > S{0});
        }
        if (active && moves) active[static_cast<unsigned>(i) / kLanes<Number>] = 1;
        store_before(end, lies, depth, i);
        store_before(end, rolls, rolling, i);
    };
}

// The velocity for views at the end of a tick, 0 where R = 0: rows y = 0 … ny-1, up to vertex `end`. Reads R,
// drop_x, drop_y; writes velocity_x, velocity_y.
template <class Number, class S = Scalar<Number>>
auto find_velocity(const StageRows<S>& w, Rows<S>& to_u, Rows<S>& to_v, int y, int end) {
    return [c = w.c, rolling = w.u0.rolling[y], drop_x = w.u0.drop_x[y], south = w.u0.drop_y[y],
            north = w.u0.drop_y[y + 1], u = to_u[y], v = to_v[y], end](int i) {
        const Number r = at<Number>(rolling, i), none(0);
        const auto moves = r > S{0};
        if (!any(moves)) {  // as it is in most places
            store_before(end, none, u, i), store_before(end, none, v, i);
            return;
        }
        const Drops<Number> drop = outward<Number>(drop_x, south, north, i);
        const Vector<Number> velocity = net_velocity(drop, pace_of(slope_dx_of(drop), r, c));
        store_before(end, select(moves, velocity.x, none), u, i);
        store_before(end, select(moves, velocity.y, none), v, i);
    };
}

}  // namespace sim::bcre
