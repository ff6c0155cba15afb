#pragma once

#include <array>
#include <string>

#include "game/recording/divergence.h"
#include "game/recording/format.h"

namespace game {

// A divergence for people: some ten lines. `names`: what to call the two runs. `scenario` is one of theirs,
// for places.
std::string to_text(const Divergence& parted, const Scenario& scenario,
                    const std::array<std::string, 2>& names);
Json to_json(const Divergence& parted, const Scenario& scenario);

// Its line of the text: "find_exchange, stage 9 in sub-step 2 of 5".
std::string stage_text(const Divergence& parted, const std::array<std::string, 2>& names);
// How many cells differ at the end of the tick.
std::size_t differing(const Divergence& parted);

}  // namespace game
