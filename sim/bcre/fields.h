#pragma once

#include <string_view>

#include "sim/bcre/constants.h"
#include "sim/simd/rows.h"
#include "sim/stages/field_list.h"
#include "sim/stages/world_rows.h"
#include "sim/world/params.h"

// The fields that the stages of `bcre` work on: the only list of them.

namespace sim::bcre {

// A Runge–Kutta state: the two layers with their slopes and velocities. A face lies west (x) or south (y) of
// its vertex. `Values` is a field, or its rows.
template <class Values>
struct RkState {
    Values depth, rolling;            // m
    Values drop_x, drop_y;            // m by which h falls through each face, to the east, to the north
    Values curvature_x, curvature_y;  // muscl: second-order part of a drop, m
    Values slope_dx;                  // slope times Δx, m
    Values velocity_x, velocity_y;    // muscl: m/s; lax-friedrichs: m added forward and subtracted backward
};
template <class Visit, class... States>
constexpr void each_layer(Visit&& visit, States&... u) {
    visit("depth", u.depth...);
    visit("rolling", u.rolling...);
}
template <class Visit, class... States>
constexpr void each_rate(Visit&& visit, States&... u) {
    visit("drop_x", u.drop_x...);
    visit("drop_y", u.drop_y...);
    visit("curvature_x", u.curvature_x...);
    visit("curvature_y", u.curvature_y...);
    visit("slope_dx", u.slope_dx...);
    visit("velocity_x", u.velocity_x...);
    visit("velocity_y", u.velocity_y...);
}

template <class Values>
struct Fields {
    RkState<Values> u0;  // the layers before the sub-step, and after it
    RkState<Values> u1;  // muscl: the predicted state at its end

    Values outflow;         // per metre of drop; lax-friedrichs: m to each side
    Values flux_x, flux_y;  // m through each face, to the east, to the north
    Values exchanged;       // muscl: m that the first RK stage erodes
    Values share;           // muscl: the share of its wanted outflow that a vertex can give
};
template <class Visit, class... Lists>
constexpr void each_transfer(Visit&& visit, Lists&... f) {
    visit("outflow", f.outflow...);
    visit("flux_x", f.flux_x...);
    visit("flux_y", f.flux_y...);
    visit("exchanged", f.exchanged...);
    visit("share", f.share...);
}
// Visits all fields except the layers of u0, which belong to the world.
template <class Visit, class... Lists>
void each_field(Visit&& visit, Lists&... f) {
    each_rate(with_prefix("u0.", visit), f.u0...);
    each_layer(with_prefix("u1.", visit), f.u1...);
    each_rate(with_prefix("u1.", visit), f.u1...);
    each_transfer(visit, f...);
}

static_assert(members_visited<RkState<char>>([](auto visit, auto& u) {
                  each_layer(visit, u), each_rate(visit, u);
              }) == sizeof(RkState<char>));
static_assert(members_visited<Fields<char>>([](auto visit, auto& f) { each_transfer(visit, f); }) ==
              sizeof(Fields<char>) - 2 * sizeof(RkState<char>));

template <class Scalar>
using StateRows = RkState<Rows<Scalar>>;

// What the stages read and write: rows of the fields, and values that all vertices share.
template <class Scalar>
struct StageRows : Fields<Rows<Scalar>>, WorldRows<Constants<Scalar>, Scalar> {};

}  // namespace sim::bcre
