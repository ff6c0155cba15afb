#pragma once

#include "sim/simd/instruction_set.h"

namespace sim {

struct State;

// Counts the standing and rolling layers exactly, and in a world of two materials the lower material in
// them. The result does not depend on the order.
void count_mass(State& state);
// The same, but reuses the counts of tiles that cannot have changed since. The first call counts all tiles.
void count_changed_mass(State& state, InstructionSet set);

}  // namespace sim
