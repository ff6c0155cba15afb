#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "game/recording/reader.h"
#include "game/scene/scenario.h"

namespace game::test {

// A slope of 13×11 vertices that uses everything a header can hold: cover, a release, no-data, place, camera,
// and numbers without a short decimal form.
Scenario small_scenario();

// One command of every kind, with numbers that are awkward to write.
std::vector<TimedCommand> some_commands();

// Plays these commands for `ticks` ticks and records them; returns the last state.
StateLine record(const std::filesystem::path& path, const Scenario& scenario, int ticks,
                 const std::vector<TimedCommand>& commands);

// A recording's lines as text, without their chain and closing brace, so that tests can change them ...
std::vector<std::string> bodies_of(const std::string& recording);
// ... and the same rechained, as a forger would: with the
// hash that docs/recording.md describes, not with our own Chain.
std::string chained(const std::vector<std::string>& bodies);
// One line without its chain, from and to JSON.
Json json_of(const std::string& body);
std::string body_of(const Json& json);

}  // namespace game::test
