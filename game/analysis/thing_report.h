#pragma once

#include <string>

#include "game/recording/json_values.h"
#include "game/scene/scenario.h"
#include "game/session/session.h"

namespace game {

// What became of the things of a world, as part of a summary. The world of `session` must have things.
// Every object with its place, strength, load, burial and state, and the results.
Json things_to_json(const Scenario& scenario, const Session& session);
// Some lines: buildings and pylons that are not intact, or all if there are few; nets and roads together.
std::string things_to_text(const Scenario& scenario, const Session& session);

}  // namespace game
