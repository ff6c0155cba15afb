#pragma once

#include <array>
#include <string_view>

#include "game/scene.h"
#include "game/toml_table.h"

namespace game {

// Names of the flows that a scene may show, for files; sim/fields/test_flows.h tells what they are.
inline constexpr std::array<std::string_view, 7> kFlowKinds{"opposed", "swinging", "pinwheel", "disc",
                                                            "drops",   "crowd",    "rift"};
inline constexpr int kMostFlowSquares = 512;  // along a side

// Reads a scene's [flow] into `start`: level ground, 100 m along a side, that flows. Faults are the table's,
// which says so itself. Errors: a wish that a flow has no use for, or too many squares.
Outcome<void> read_flow(TomlTable& table, const Wishes& wishes, Start& start);

}  // namespace game
