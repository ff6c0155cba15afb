#pragma once

#include <utility>
#include <vector>

#include "sim/grid.h"
#include "sim/layers.h"

namespace sim {

// A face between ground and drain: that of vertex (x, y) toward east or north in flux_x or flux_y. `sign` is
// +1 where ground lies on the west or south side, so that sign × flux leaves the world.
struct DrainFace {
    int x, y;
    bool along_x;
    int sign;
};

// Momentum per area that a sub-step carries through each face, m²/s: of the layer's u and v.
template <class Number>
struct Momentum {
    Field<Number> u, v;
};

// What a step needs between its stages; holds nothing from one sub-step to the next. Made once per world, so
// that a step allocates nothing.
template <class Number>
struct Scratch {
    explicit Scratch(const Layers<Number>& layers);

    Field<Number> flux_x;  // m of depth through the face (x, y)–(x+1, y) in a sub-step, east positive
    Field<Number> flux_y;  // m of depth through the face (x, y)–(x, y+1), north positive
    Field<Number> outflow_scale;  // 1, or less where a vertex would give more than it has
    Field<Number> rolling;        // m, after transport
    Field<Number> velocity_x;     // m/s, after transport
    Field<Number> velocity_y;     // m/s
    Field<Number> slope;          // tangent toward the lower neighbours of h
    Field<Number> slope_spread;   // (|g_x| + |g_y|) / |g| of it, 1 to √2

    // For what is of second order in time.
    Field<Number> exchanged;                                    // m in a sub-step, erosion positive
    Field<Number> depth;                                        // m, predicted
    Field<Number> first_flux_x, first_flux_y, first_exchanged;  // at the sub-step's beginning

    Momentum<Number> momentum_x, momentum_y;  // with flux_x and with flux_y, of bcre-inertial

    std::vector<DrainFace> drain_faces;
    std::vector<std::pair<int, int>> drain_vertices;  // no-data vertices beside ground
};

template <class Number>
Scratch(const Layers<Number>&) -> Scratch<Number>;

}  // namespace sim
