#pragma once

#include "sim/world/forward.h"

namespace sim {

// Finds S₀ = |∇(b + d)| of the vertices x0 … x1, y0 … y1. The halo of the depth must be filled.
template <class Number>
void find_first_slope(Layers<Number>& layers, const Params& params, int x0, int x1, int y0, int y1);

// Finds what follows from the ground where its bedrock has changed: the halo, S₀ there and at the vertices beside it,
// and walls. Wakes the tiles there. Does nothing if no bedrock has changed.
void renew_ground(State& state);

}  // namespace sim
