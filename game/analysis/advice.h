#pragma once

#include <optional>
#include <string>

#include "game/analysis/score.h"
#include "game/scene/goal.h"
#include "game/session/attempt_watch.h"
#include "game/session/peak_watch.h"
#include "sim/world/state.h"

namespace game {

// What a lost try shows a person that numbers do not: from where the house with the greatest load was hit, if a need on houses
// is not met; what the flow did at the earth that was heaped up against it; and how much of the slab that the scene let go
// lay there still, if the tools could have taken it away. Empty if there is nothing to tell.
std::string advice_after(const Goal& goal, const Score& score, const sim::View& world, const Peaks& peaks,
                         const std::optional<AttemptWatch::Slab>& slab);

}  // namespace game
