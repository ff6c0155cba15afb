#pragma once

#include <span>
#include <string>
#include <vector>

#include "game/scene/scenario.h"

namespace game {

// What differs in two worlds' beginnings, a clause each: "stop_slope is 0.5 in the first and 0.6 in the
// second". Of what is only seen, nothing. Empty: runs of the same commands must not part.
std::vector<std::string> differences_of(const Scenario& a, const Scenario& b);

// The same of their commands, in order of their ticks: "at tick 60 the pour's x is 80 in the first and 100 in
// the second".
std::vector<std::string> differences_of(std::span<const TimedCommand> a, std::span<const TimedCommand> b);

// Why worlds cannot be laid over one another: other ground, another grid. Nothing if they can.
std::vector<std::string> differences_of_ground(const Scenario& a, const Scenario& b);

// A command for people: "pour x=80 y=138 radius=9 rate=383 duration=1 as=standing profile=cone".
std::string to_text(const sim::Command& command);

}  // namespace game
