#include "game/scene/standing.h"

#include <algorithm>
#include <vector>

#include "sim/initial_state.h"

namespace game {

bool places_things(sim::CommandKind kind) {
    return kind >= sim::CommandKind::kSculpt;
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
    const auto fault_of_first = [&](std::size_t count) {
        return sim::fault_of_things(state, placed.first(count));
    };
    if (!fault_of_first(placed.size())) return std::nullopt;
    // What is wrong with some commands stays wrong if more follow.
    std::size_t sound = 0, wrong = placed.size();
    while (wrong - sound > 1) {
        const std::size_t middle = sound + (wrong - sound) / 2;
        (fault_of_first(middle) ? wrong : sound) = middle;
    }
    return PlacedFault{wrong - 1, *fault_of_first(wrong)};
}

}  // namespace game
