#pragma once

#include "game/analysis/score.h"
#include "game/scene/scenario.h"
#include "game/ui/facts.h"

namespace game {

// What a try at the goal of `scenario` came to, in words.
ui::ResultCard card_of(const Scenario& scenario, const Score& score);

}  // namespace game
