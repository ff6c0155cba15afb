#include "game/scene/standing.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "sim/initial_state.h"
#include "sim/world/quanta.h"
#include "sim/world/thing_places.h"

namespace game {

bool places_things(sim::CommandKind kind) {
    return kind >= sim::CommandKind::kSculpt && kind <= sim::CommandKind::kRemove;
}

bool has_things(std::span<const TimedCommand> commands) {
    return std::ranges::any_of(commands, [](const TimedCommand& timed) {
        const sim::CommandKind kind = timed.command.kind;
        return places_things(kind) || kind == sim::CommandKind::kWet;
    });
}

std::optional<PlacedFault> fault_of_placed(const Scenario& scenario) {
    const std::span<const sim::Command> placed = scenario.standing.placed;
    if (placed.empty()) return std::nullopt;
    for (std::size_t i = 0; i < placed.size(); ++i)
        if (const auto wrong = sim::fault_of(placed[i])) return PlacedFault{i, *wrong};
    if (const auto wrong = sim::fault_of_visits(scenario.grid, placed, sim::kAlwaysVisitsBefore))
        return PlacedFault{0, *wrong};

    sim::InitialState world = initial_state_of(scenario);
    world.standing.placed = {};
    const sim::State state = sim::make_state(world, scenario.params);
    if (auto wrong = sim::fault_of_things(state, placed))
        return PlacedFault{wrong->command, std::move(wrong->fact)};
    return std::nullopt;
}

namespace {

bool is_in_quanta(float metres) {
    return sim::nearest_quanta(metres) == metres;  // not of NaN
}

// What is wrong with a field of the lower material that `most(vertex)` bounds, m.
template <class Most>
std::optional<std::string> fault_of_part(const std::vector<float>& part, std::size_t vertices,
                                         const char* name, Most&& most) {
    if (part.empty()) return std::nullopt;
    if (part.size() != vertices)
        return fmt::format("{} has {} values for {} vertices", name, part.size(), vertices);
    for (std::size_t i = 0; i < vertices; ++i)
        if (!is_in_quanta(part[i]) || part[i] < 0 || part[i] > most(i))
            return fmt::format("{} has {} m at vertex {}, where at most {} m can be", name, part[i], i,
                               most(i));
    return std::nullopt;
}

}  // namespace

std::optional<std::string> fault_of_earth(const Scenario& scenario) {
    const Scenario::Standing& standing = scenario.standing;
    if (standing.earth.empty()) return std::nullopt;
    if (standing.earth.size() != scenario.grid.size())
        return fmt::format("earth has {} values for {} vertices", standing.earth.size(),
                           scenario.grid.size());
    sim::EarthMoved moved;
    for (std::size_t i = 0; i < standing.earth.size(); ++i) {
        const float earth = standing.earth[i];
        if (!is_in_quanta(earth) || std::abs(static_cast<double>(earth)) > sim::kHighestEarth)
            return fmt::format("earth of {} m at vertex {} is not in whole quanta within {} m", earth, i,
                               sim::kHighestEarth);
        if (earth != 0 && scenario.has_data[i] == 0)
            return fmt::format("earth at vertex {}, where the terrain has no data", i);
        moved.add(std::llrint(earth / sim::kQuantum));
    }
    const double cubic_metres = scenario.grid.cell_area() * static_cast<double>(sim::kQuantum);
    if (standing.earth_budget < 0 || moved.used() <= std::llrint(standing.earth_budget / cubic_metres))
        return std::nullopt;
    return fmt::format("earth of {:.1f} m3, and the budget is {:.1f} m3",
                       static_cast<double>(moved.used()) * cubic_metres, standing.earth_budget);
}

std::optional<std::string> fault_of_water(const Scenario& scenario) {
    const std::vector<float>& water = scenario.standing.water;
    if (water.empty()) return std::nullopt;
    if (water.size() != scenario.grid.size())
        return fmt::format("water has {} values for {} vertices", water.size(), scenario.grid.size());
    for (std::size_t i = 0; i < water.size(); ++i) {
        const float quanta = water[i] / sim::kWaterQuantum;
        if (!(water[i] >= 0 && water[i] <= 1) || std::rint(quanta) != quanta)  // NaN too
            return fmt::format("water of {} at vertex {} is not in whole quanta from 0 to 1", water[i], i);
        if (water[i] != 0 && scenario.has_data[i] == 0)
            return fmt::format("water at vertex {}, where the terrain has no data", i);
    }
    return std::nullopt;
}

std::optional<std::string> fault_of_mixed(const Scenario& scenario) {
    if (!scenario.lower) return std::nullopt;
    const Scenario::Lower& lower = *scenario.lower;
    const auto above = [&](std::size_t i) {
        const float depth = sim::nearest_quanta(scenario.depth[i]);
        return depth - std::min(sim::nearest_quanta(lower.depth[i]), depth);
    };
    const auto rolling = [&](std::size_t i) { return sim::nearest_quanta(scenario.rolling[i]); };
    if (auto fault = fault_of_part(lower.settled, scenario.grid.size(), "settled", above)) return fault;
    return fault_of_part(lower.rolling, scenario.grid.size(), "rolling", rolling);
}

double earth_needed(const Scenario& scenario) {
    const auto sculpts = [](const sim::Command& command) {
        return command.kind == sim::CommandKind::kSculpt;
    };
    if (std::ranges::none_of(scenario.standing.placed, sculpts)) return 0;
    sim::InitialState world = initial_state_of(scenario);
    world.standing.earth_budget = -1;
    const sim::State state = sim::make_state(world, scenario.params);
    return static_cast<double>(sim::earth_used(*state.things)) * static_cast<double>(sim::kQuantum) *
           scenario.grid.cell_area();
}

}  // namespace game
