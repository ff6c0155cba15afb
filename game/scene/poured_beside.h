#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "game/scene/timed_command.h"
#include "sim/core/grid.h"

namespace game {

// Whether commands of a scene pour where nothing can lie: beyond the grid, or where the terrain has no data. One sentence
// with their number and the worst of them, how much of its disc that is; none if all lie on ground.
std::optional<std::string> warning_of_pours(const sim::Grid& grid, const std::vector<std::uint8_t>& has_data,
                                            const std::vector<TimedCommand>& commands);

}  // namespace game
