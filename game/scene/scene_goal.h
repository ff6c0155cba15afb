#pragma once

#include "game/files/toml_table.h"
#include "game/scene/goal.h"

namespace game {

// Reads [goal] of a scene, without its events. Faults go to the table's fault.
Goal read_goal(TomlTable& table);

}  // namespace game
