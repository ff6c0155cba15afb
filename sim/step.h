#pragma once

#include <span>

#include "sim/command.h"

namespace sim {

class Workers;
struct Scratch;
struct State;

// One tick: the commands given for it, then as many sub-steps as the parameters ask for. The only way in
// which a state changes. Same state and commands: same bits, whatever compiler, level,
// instruction set or number of workers. `scratch` is one made for this state's world. Allocates nothing
// unless more sources run than ever before.
void step(State& state, std::span<const Command> commands, Scratch& scratch, Workers& workers);

}  // namespace sim
