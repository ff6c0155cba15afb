#pragma once

#include <span>

#include "sim/world/command.h"
#include "sim/world/forward.h"

namespace sim {

struct Engine;
struct Substeps;

// Runs one tick: its commands, then as many sub-steps as the parameters require; or, if the state is_calm() and there are no
// commands, an hour of weather. A state changes in no other way. The result is bit-identical for any compiler, optimisation level, instruction set, number of threads
// and executor. `engine` must be made for this state's world. Allocates only if more commands run than ever
// before.
void step(State& state, std::span<const Command> commands, Engine& engine);

// How many sub-steps a tick of this world has, and how long they are: in a mixed one, as the faster material
// asks for.
Substeps substeps_of(const State& state);

// One sub-step of it, without commands and ledger, on the layers alone.
template <class Number>
void substep(Layers<Number>& layers, const Params& params, Scratch<Number>& scratch, Workers& workers,
             Substep<Number> sub);

}  // namespace sim
