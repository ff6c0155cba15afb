#pragma once

#include "game/files/toml_table.h"
#include "game/scene/flow_kinds.h"
#include "game/scene/scene.h"

namespace game {

// Reads a scene's [flow] into `scenario`: level ground, 100 m along a side, that flows. Faults are the
// table's, which says so itself. Errors: a wish that a flow has no use for, or too many squares.
Outcome<void> read_flow(TomlTable& table, const Overrides& overrides, Scenario& scenario);

}  // namespace game
