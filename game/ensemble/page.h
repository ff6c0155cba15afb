#pragma once

#include <span>
#include <string>

#include "game/ensemble/maps.h"

namespace game {

// All that an ensemble came to, as one page that needs no other file and no network: maps, the spread of its numbers, what
// each variable does to them, and every input and hash with which it can be made again. `pictures`: of maps, as PNG.
std::string page_of(const EnsembleSpec& spec, const EnsembleResult& result, std::span<const EnsembleMap> maps,
                    std::span<const std::string> pictures);

}  // namespace game
