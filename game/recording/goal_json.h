#pragma once

#include "game/recording/json_values.h"
#include "game/scene/goal.h"

// The goal of a challenge, as the "goal" of a recording's header.
namespace game::values {

Json goal_json(const Goal& goal);
// Throws as the readers of json_values.h.
Goal goal_from(const Json& json);

}  // namespace game::values
