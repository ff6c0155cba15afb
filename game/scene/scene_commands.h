#pragma once

#include <vector>

#include "game/files/toml_table.h"
#include "game/scene/timed_command.h"
#include "sim/world/command.h"

namespace game {

// Reads the members of a command from its table. Faults go to the table's fault.
sim::Command read_command(TomlTable& table, const sim::CommandInfo& info, bool has_lower);

// Reads [[command]], sorted by tick.
std::vector<TimedCommand> read_commands(TomlTable& root, double tick_s, bool has_lower);

}  // namespace game
