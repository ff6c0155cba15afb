#pragma once

#include "tests/support/worlds.h"

namespace bench {

// The worst case for a step: a rough slope between walls, so that nothing leaves, with half a metre rolling
// everywhere; one sub-step per tick.
support::Play world_of(int squares, sim::Model model, sim::Scheme scheme,
                       const sim::StepOptions& options = {});

// Registers a benchmark for each stage of a step.
void add_stages();
// Registers benchmarks of fronts and the textures beside them.
void add_fronts();

}  // namespace bench
