#pragma once

#include "game/files/toml_table.h"
#include "render/structures.h"

namespace game {

// Reads [[hut]], [[road]] and [[lift]] of a scene. Faults go to the table's fault. Whether the terrain is there is for
// fault_of() (structures.h) to say.
render::Structures read_structures(TomlTable& root);

}  // namespace game
