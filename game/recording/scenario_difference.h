#pragma once

#include <span>
#include <string>
#include <vector>

#include "game/scene/scenario.h"

namespace game {

// Lists the differences between two scenarios, a clause each: "stop_slope is 0.5 in the first and 0.6 in the
// second". Appearance is not compared. Empty: runs of the same commands must be bit-identical.
std::vector<std::string> differences_of(const Scenario& a, const Scenario& b);

// Lists the differences between their commands, sorted by tick: "at
// tick 60 the pour's x is 80 in the first and 100 in the second".
std::vector<std::string> differences_of(std::span<const TimedCommand> a, std::span<const TimedCommand> b);

// Why two worlds cannot be compared cell by cell: another ground or another grid. Empty if they can.
std::vector<std::string> differences_of_ground(const Scenario& a, const Scenario& b);

// Formats a command: "pour x=80 y=138 radius=9 rate=383 duration=1 as=standing profile=cone".
std::string to_text(const sim::Command& command);

}  // namespace game
