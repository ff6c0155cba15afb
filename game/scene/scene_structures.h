#pragma once

#include "game/files/toml_table.h"
#include "game/scene/scene_things.h"
#include "render/structures.h"

namespace game {

// Whether huts, roads, lifts and trees of a scene act on a flow. If not, they are for the eye alone.
inline constexpr bool kStructuresAct = false;

// Reads [[hut]], [[road]] and [[lift]] of a scene; they become `things` if structures act. Faults go to the table's
// fault. Whether the terrain is there is for fault_of() (structures.h) or stand() to say.
render::Structures read_structures(TomlTable& root, ThingsTables& things);

}  // namespace game
