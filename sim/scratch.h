#pragma once

#include "sim/grid.h"
#include "sim/layers.h"
#include "sim/outlets.h"

namespace sim {

// What is carried of both components of R v.
template <class Number>
struct Momentum {
    Field<Number> u, v;
};

// One value per vertex and direction.
template <class Number>
struct Directions {
    Field<Number> east, west, north, south;
};

// What a step needs between its stages; holds nothing from one sub-step to the next. Made once per world, so
// that a step allocates nothing.
template <class Number>
struct Scratch {
    explicit Scratch(const Layers<Number>& layers);

    Field<Number> flux_x;        // m of depth through the face (x, y)–(x+1, y) in a sub-step, east positive
    Field<Number> flux_y;        // m of depth through the face (x, y)–(x, y+1), north positive
    Field<Number> rolling;       // m, after transport
    Field<Number> velocity_x;    // m/s, after transport
    Field<Number> velocity_y;    // m/s
    Field<Number> slope;         // tangent toward the lower neighbours of h
    Field<Number> slope_spread;  // (|g_x| + |g_y|) / |g| of it, 1 to √2

    Directions<Number> down;   // m from a vertex down to its lower neighbours
    Field<Number> fall;        // m over a cell, slope times Δx
    Field<Number> pace;        // 1/s, speed per drop
    Directions<Number> given;  // m that a vertex gives to its neighbours in a sub-step

    // Of bcre-inertial.
    Momentum<Number> momentum_x, momentum_y;   // m²/s, with flux_x and with flux_y
    Field<Number> first_flux_x, first_flux_y;  // at the sub-step's beginning

    // For what is of second order in time.
    Field<Number> exchanged;         // m in a sub-step, erosion positive
    Field<Number> depth;             // m, predicted
    Directions<Number> first_given;  // at the sub-step's beginning
    Field<Number> first_exchanged;   // the same

    Outlets outlets;
};

template <class Number>
Scratch(const Layers<Number>&) -> Scratch<Number>;

}  // namespace sim
