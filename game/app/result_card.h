#pragma once

#include <span>

#include "game/analysis/best_runs.h"
#include "game/analysis/score.h"
#include "game/scene/scenario.h"
#include "game/ui/facts.h"

namespace game {

// What a try at the goal of `scenario` came to, in words. `earlier`: the best runs without it, the best first.
ui::ResultCard card_of(const Scenario& scenario, const Score& score, std::span<const BestRun> earlier);

}  // namespace game
