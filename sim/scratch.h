#pragma once

#include <vector>

#include "sim/grid.h"
#include "sim/state.h"

namespace sim {

// A face between ground and drain: that of vertex (x, y) toward east or north in flux_x or flux_y. `sign` is
// +1 where ground lies on the west or south side, so that sign × flux leaves the world.
struct DrainFace {
    int x, y;
    bool along_x;
    int sign;
};

// What a step needs between its stages; holds nothing from one sub-step to the next. Made once per world, so
// that a step allocates nothing.
struct Scratch {
    explicit Scratch(const State& state);

    Field<float> flux_x;         // m of depth through the face (x, y)–(x+1, y) in a sub-step, east positive
    Field<float> flux_y;         // m of depth through the face (x, y)–(x, y+1), north positive
    Field<float> outflow_scale;  // 1, or less where a vertex would give more than it has
    Field<float> rolling;        // m, after transport
    Field<float> velocity_x;     // m/s, after transport
    Field<float> velocity_y;     // m/s
    Field<float> slope;          // tangent toward the lower neighbours of h
    Field<float> slope_spread;   // (|g_x| + |g_y|) / |g| of it, 1 to √2

    std::vector<DrainFace> drain_faces;
    std::vector<std::pair<int, int>> drain_vertices;  // no-data vertices beside ground
};

}  // namespace sim
