#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "game/scene.h"
#include "game/toml_table.h"

namespace game {

// Names of the flows that a scene may show, for files; sim/fields/test_flows.h tells what they are.
inline constexpr std::array<std::string_view, 7> kFlowKinds{"opposed", "swinging", "pinwheel", "disc",
                                                            "drops",   "crowd",    "rift"};

// Reads a scene's [flow] into `start`: level ground, 100 m along a side, that flows. `wished`: squares along
// a side, instead of those that the file says. Faults are the table's, which says so itself. Errors: the
// material that such a world is given without using it cannot be loaded.
Outcome<void> read_flow(TomlTable& table, std::optional<int> wished, Start& start);

}  // namespace game
