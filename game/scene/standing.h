#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "game/base/limits.h"
#include "game/scene/scenario.h"

namespace game {

// What stands on a scenario's ground at tick 0, and what is wrong with it.

inline constexpr double kGreatestEarthBudget = 1e9;  // m³

// Whether a command of this kind may stand in Scenario::Standing::placed: it changes things, not layers or parameters.
bool places_things(sim::CommandKind kind);

// Whether these commands may give a world things.
bool has_things(std::span<const TimedCommand> commands);

struct PlacedFault {
    std::size_t index;  // in Scenario::Standing::placed
    std::string fact;   // such as "the house at (10, 20) stands on the house at (12, 20)"
};
// The first command that cannot be done on the scenario's ground, one after another; nothing if all can.
std::optional<PlacedFault> fault_of_placed(const Scenario& scenario);
// What is wrong with the earth of a scenario; nothing if sculpting can make it: whole quanta, at most
// sim::kHighestEarth above or below natural ground, none where there is no data, and all within the budget.
std::optional<std::string> fault_of_earth(const Scenario& scenario);
// The same of water in the soil: whole quanta of 0 to 1, none where there is no data.
std::optional<std::string> fault_of_water(const Scenario& scenario);
// The same of where two materials are mixed: whole quanta, no more than the layers have.
std::optional<std::string> fault_of_mixed(const Scenario& scenario);
// Earth that the placed commands use if there is no budget, m³. They must be without fault.
double earth_needed(const Scenario& scenario);

}  // namespace game
