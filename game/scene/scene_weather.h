#pragma once

#include <vector>

#include "game/files/toml_table.h"
#include "game/scene/scenario.h"

namespace game {

// A scene's [weather]: the calendar, and its [[weather.storm]], [[weather.wind]] and [[weather.temperature]], which become
// the first commands of tick 0. Faults go to the table's fault.
sim::Calendar read_weather(TomlTable& table, const Scenario& scenario, std::vector<TimedCommand>& commands);

// Once the ground is known: what the table leaves out follows from it. The amounts are for its lowest place, and the
// latitude is its own, if its place on Earth is known.
void place_weather(TomlTable& table, Scenario& scenario);

}  // namespace game
