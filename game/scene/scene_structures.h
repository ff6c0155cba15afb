#pragma once

#include "game/files/toml_table.h"
#include "game/scene/scene_things.h"

namespace game {

// Reads [[hut]], [[road]] and [[lift]] of a scene. Faults go to the table's fault; stand() adds those of the ground.
void read_structures(TomlTable& root, ThingsTables& things);

}  // namespace game
