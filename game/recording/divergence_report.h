#pragma once

#include <array>
#include <string>

#include "game/recording/divergence.h"
#include "game/recording/format.h"

namespace game {

// Describes a divergence in some ten lines. `names`: what to
// call the two runs. `scenario`: either run's, for places.
std::string to_text(const Divergence& parted, const Scenario& scenario,
                    const std::array<std::string, 2>& names);
Json to_json(const Divergence& parted, const Scenario& scenario);

// The stage as the text shows it: "find_exchange, stage 9 in sub-step 2 of 5".
std::string stage_text(const Divergence& parted, const std::array<std::string, 2>& names);
// Number of cells that differ at the end of the tick.
std::size_t differing(const Divergence& parted);

}  // namespace game
