#pragma once

#include <span>

#include "sim/world/command.h"
#include "sim/world/forward.h"

namespace sim {

struct Engine;
struct Substeps;

// One tick: the commands given for it, then as many sub-steps as the parameters ask for. The only way in
// which a state changes. Same state and commands: same bits, whatever compiler, level,
// instruction set, number of threads or way of reckoning. `engine` is one made for this state's world.
// Allocates nothing unless more sources run than ever before.
void step(State& state, std::span<const Command> commands, Engine& engine);

// How many sub-steps a tick of this world has, and how long they are: in a mixed one, as the faster material
// asks for.
Substeps substeps_of(const State& state);

// One sub-step of it, without commands and ledger, on the layers alone.
template <class Number>
void substep(Layers<Number>& layers, const Params& params, Scratch<Number>& scratch, Workers& workers,
             Substep<Number> sub);

}  // namespace sim
