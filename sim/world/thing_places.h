#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace sim {

struct Command;
struct Grid;
struct State;

// What can be known of commands of things before they are done.

// Whether a command builds, turns or removes objects.
bool is_of_objects(const Command& command);

// What is wrong with a command in this world at any time, whatever stands there: the place or the length of what is built,
// or soil that water does not act on. Nothing for other commands.
std::optional<std::string> fault_of_place(const State& state, const Command& command);

// Whether `wet` and `drain` act in this world, which is everywhere the same: it has a model with friction, and materials
// heavier than water.
bool takes_water(const State& state);

// Commands of things cost time by the vertices that they visit: those of a disc, and once the whole grid for objects
// in a row. In one tick they may visit kMostVisits times the grid, a few times what the tick itself does, or
// kAlwaysVisits if that is more. Those before tick 0 are done once, so that they may visit kAlwaysVisitsBefore.
inline constexpr std::int64_t kMostVisits = 16, kAlwaysVisits = std::int64_t{1} << 22,
                              kAlwaysVisitsBefore = std::int64_t{1} << 26;
// What is wrong with the work of commands that are done together; `always`: what is allowed on any grid.
std::optional<std::string> fault_of_visits(const Grid& grid, std::span<const Command> commands,
                                           std::int64_t always = kAlwaysVisits);

}  // namespace sim
