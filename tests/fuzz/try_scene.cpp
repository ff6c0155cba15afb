#include "tests/fuzz/try_reader.h"

#include <algorithm>

#include "game/scene/scene.h"
#include "game/scene/standing.h"
#include "sim/world/params.h"

namespace game::test {
namespace {

Outcome<void> try_scene(const std::filesystem::path& file) {
    Overrides overrides;
    overrides.squares = kTriedSquares;
    const auto scene = load_scene(file.string(), overrides);
    if (!scene) return tl::unexpected(scene.error());
    const Scenario& scenario = scene->scenario;
    if (const auto fault = sim::fault_of(scenario.params)) return broken(*fault);
    for (const TimedCommand& timed : scene->commands)
        if (const auto fault = sim::fault_of(timed.command, scenario.lower.has_value()))
            return broken(*fault);
    if (const auto fault = fault_of_placed(scenario)) return broken(fault->fact);
    if (!scenario.standing.forest.empty() && scenario.standing.forest.size() != scenario.grid.size())
        return broken("a forest beside the grid");
    if (!std::ranges::is_sorted(scene->commands, {}, &TimedCommand::tick))
        return broken("commands out of order");
    return check_numbers(scenario.bedrock, -1e5f, 1e5f, "bedrock")
        .and_then([&] { return check_numbers(scenario.depth, 0, 1000, "a depth"); })
        .and_then([&] { return check_numbers(scenario.rolling, 0, 1000, "a release"); });
}

}  // namespace

const TriedReader kTriedScene{"scene", "x.toml", try_scene};

}  // namespace game::test
