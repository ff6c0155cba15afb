#include "game/scene/standing.h"

#include <algorithm>
#include <utility>

#include "sim/initial_state.h"
#include "sim/world/quanta.h"

namespace game {

bool places_things(sim::CommandKind kind) {
    return kind >= sim::CommandKind::kSculpt && kind <= sim::CommandKind::kRemove;
}

bool has_things(std::span<const TimedCommand> commands) {
    return std::ranges::any_of(commands,
                               [](const TimedCommand& timed) { return places_things(timed.command.kind); });
}

std::optional<PlacedFault> fault_of_placed(const Scenario& scenario) {
    const std::span<const sim::Command> placed = scenario.standing.placed;
    if (placed.empty()) return std::nullopt;
    for (std::size_t i = 0; i < placed.size(); ++i)
        if (const auto wrong = sim::fault_of(placed[i])) return PlacedFault{i, *wrong};

    sim::InitialState world = initial_state_of(scenario);
    world.standing.placed = {};
    const sim::State state = sim::make_state(world, scenario.params);
    if (auto wrong = sim::fault_of_things(state, placed))
        return PlacedFault{wrong->command, std::move(wrong->fact)};
    return std::nullopt;
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
