#pragma once

#include "game/recording/json_values.h"
#include "game/scene/scenario.h"

// What stands at tick 0, as the "things" of a recording's header.
namespace game::values {

Json things_json(const Scenario& scenario);
// Call after the ground is read: forest and commands are checked on it. Throws as the readers of json_values.h.
void things_from(const Json& json, Scenario& scenario);

}  // namespace game::values
