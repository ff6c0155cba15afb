#pragma once

#include "sim/simd/instruction_set.h"

namespace sim {

struct State;

// Counts standing and rolling layers anew, and of a mixed world the lower material in them, exactly, in any
// order.
void count_mass(State& state);
// The same, but reuses the counts of tiles that cannot have changed since. The first call counts all tiles.
void count_changed_mass(State& state, InstructionSet set);

}  // namespace sim
