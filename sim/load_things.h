#pragma once

#include "sim/world/forward.h"

namespace sim {

// What the flow of a tick does to what stands in the world:
//
//     p = ρ |v|²        |v| along the slope; toward a wall of a solid building, the part of v toward it
//     q = p min(1, h/1 m)                  h = R cos θ: the load, by which objects are damaged
//     a stem breaks where ½ C_d p D h · h/2 > M
//
// Keeps the greatest load and burial of each object; what is destroyed no longer acts. Reads R, d, d₀, v and the
// smoothed ground at vertices with things only, of forest only in tiles that were written in this tick: in others
// nothing has changed. Writes things, and bedrock where a solid building falls. Call at the end of a tick, before
// count_changed_mass().
void load_things(State& state);

}  // namespace sim
