#pragma once

#include <span>
#include <string>

#include "game/analysis/best_runs.h"
#include "game/analysis/score.h"
#include "game/scene/scenario.h"
#include "game/ui/facts.h"

namespace game {

// What a try at the goal of `scenario` came to, in words. `earlier`: the best runs without it, the best first. `advice`: what a
// lost one shows.
// The map of the card is left to the caller.
ui::ResultCard card_of(const Scenario& scenario, const Score& score, std::span<const BestRun> earlier,
                       const std::string& advice = "");
// What slides in free play came to, since the world began, measured after so many seconds of the world.
ui::ResultCard card_of_slide(const Scenario& scenario, const Measures& measures, double seconds);

}  // namespace game
