#pragma once

#include "game/files/toml_table.h"
#include "game/scene/flow_kinds.h"
#include "game/scene/scene.h"

namespace game {

// Reads a scene's [flow] into `scenario`: level ground, 100 m along each side, with a flow. Faults are
// reported by the table. Errors: an override that does not apply to a flow, or too many squares.
Outcome<void> read_flow(TomlTable& table, const Overrides& overrides, Scenario& scenario);

}  // namespace game
