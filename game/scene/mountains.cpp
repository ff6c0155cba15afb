#include "game/scene/mountains.h"

#include <cstddef>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "game/scene/structures.h"

namespace game {

render::Surroundings mountains_around(const Scenario& scenario) {
    if (scenario.flow) return {};
    const std::vector<float> none;
    return {scenario.grid, scenario.bedrock, scenario.depth, scenario.has_data,
            scenario.lower ? scenario.lower->depth : none};
}

namespace {

// No trees stand in a house, on a road or under a rope.
std::vector<render::Clearing> clearings_of(const render::Structures& structures) {
    constexpr double kAround = 5, kBesideRoad = 5, kBesideRope = 9;  // m
    std::vector<render::Clearing> clearings;
    for (const render::Structure& each : structures.all)
        clearings.push_back({each.at, each.at, glm::length(render::half_footprint(each)) + kAround});
    for (const render::Road& road : structures.roads)
        for (std::size_t i = 1; i < road.points.size(); ++i)
            clearings.push_back({road.points[i - 1], road.points[i], road.width_m / 2 + kBesideRoad});
    for (const render::Lift& lift : structures.lifts) {
        const auto [valley, mountain] = stations(structures, lift);
        clearings.push_back({valley, mountain, kBesideRope});
    }
    return clearings;
}

}  // namespace

render::Woods woods_on(const Scenario& scenario, const render::Surroundings& mountains) {
    render::Woods woods(mountains, scenario.trees, scenario.datum, clearings_of(scenario.structures));
    if (scenario.woods_act) woods.let_act();
    return woods;
}

std::string woods_notice(const Scenario& scenario, const render::Woods& woods) {
    if (!scenario.model && !scenario.flow && scenario.trees.density > 0 && woods.empty())
        return "The scene asks for trees, and there is no place for one. Compare tree_line, polygon and "
               "raster of [trees] with the ground";
    if (woods.asked() <= static_cast<double>(woods.trees().size())) return "";
    return fmt::format("The scene asks for {:.0f} trees, and {} are drawn. Use a smaller [trees] density",
                       woods.asked(), woods.trees().size());
}

}  // namespace game
