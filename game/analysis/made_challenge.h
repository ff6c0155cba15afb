#pragma once

#include <atomic>
#include <filesystem>

#include "game/analysis/score.h"
#include "game/base/outcome.h"
#include "game/scene/scenario.h"
#include "game/session/sandbox.h"
#include "sim/step.h"

namespace game {

// The goal of a challenge of what a person did: the same world, and at most the tools that they used, as often, as much
// and as large. The scene's own commands and parameters that they set are events. It has no medals and no needs yet.
// Errors: nothing was done (status 2).
Outcome<Goal> goal_of(const Scenario& scenario, const History& history);

// Makes that challenge: plays what was done until the try ends, and sets what must be so and the medals by what it
// reached there. Gold is its run-out, rounded down; silver and bronze are 80 and 60 % of that. What it did to houses and
// roads is the most that may happen to them. Then it is played again, recorded and scored: the file, which is written
// whole or not at all, proves that gold can be won. Returns its scenario.
// Errors: it was stopped, the try does not end or reaches too little, it does not win gold when it is played again, or the
// file cannot be written.
Outcome<Scenario> make_challenge(const Scenario& scenario, const History& history,
                                 const sim::StepOptions& options, const std::filesystem::path& file,
                                 const std::atomic<bool>& stop);

}  // namespace game
