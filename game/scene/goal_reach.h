#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "game/scene/scenario.h"

namespace game {

// What no try at a challenge can reach on its ground, by the bounds of each measure alone: an area without a vertex, a
// zone beside the grid, more houses destroyed than can stand, a share over 100 %, a medal above the greatest score.
struct ReachFault {
    std::string_view table;  // "need", "score"; empty: the goal itself
    std::size_t index = 0;   // of those tables
    std::string_view key;    // "least"
    std::string fact;        // "is 3, and at most 2 houses can stand there"
};
// The first one. `scenario` needs a goal without fault_of(), its ground, and what stands there.
std::optional<ReachFault> fault_of_reach(const Scenario& scenario);
// "need 2: least is 3, and …", for a file without lines.
std::string to_text(const ReachFault& fault);

}  // namespace game
