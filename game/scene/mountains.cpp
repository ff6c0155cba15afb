#include "game/scene/mountains.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace game {

render::Surroundings mountains_around(const Scenario& scenario) {
    if (scenario.flow) return {};
    const std::vector<float> none;
    return {scenario.grid, scenario.bedrock, scenario.depth, scenario.has_data,
            scenario.lower ? scenario.lower->depth : none};
}

namespace {

constexpr double kAround = 5, kBesideRoad = 5, kBesideRope = 9;  // m

// No trees stand in a house, on a road or under a rope of tick 0.
std::vector<render::Clearing> clearings_of(const Scenario& scenario) {
    std::vector<render::Clearing> clearings;
    for (const sim::Command& each : scenario.standing.placed) {
        const glm::dvec2 from(each.x, each.y), to(each.to_x, each.to_y);
        if (each.kind == sim::CommandKind::kHouse)
            clearings.push_back({from, from, glm::length(glm::dvec2(each.length, each.width)) / 2 + kAround});
        if (each.kind == sim::CommandKind::kRoad)
            clearings.push_back({from, to, each.width / 2 + kBesideRoad});
        if (each.kind != sim::CommandKind::kLift) continue;
        clearings.push_back({from, to, kBesideRope});
        const double station = glm::length(glm::dvec2(sim::kStationLength, sim::kStationWidth)) / 2 + kAround;
        clearings.insert(clearings.end(), {{from, from, station}, {to, to, station}});
    }
    return clearings;
}

render::Settlement settlement_of(const Scenario& scenario) {
    render::Settlement settlement;
    for (const sim::Command& each : scenario.standing.placed) {
        const glm::dvec2 at(each.x, each.y);
        const double turn = glm::radians(each.turn);
        if (each.kind == sim::CommandKind::kHouse)
            settlement.houses.push_back({at, {std::sin(turn), std::cos(turn)}, each.length, each.width});
        if (each.kind == sim::CommandKind::kRoad && (each.to_x != each.x || each.to_y != each.y))
            settlement.roads.push_back({at, {each.to_x, each.to_y}, each.width});
    }
    return settlement;
}

}  // namespace

render::Land land_on(const Scenario& scenario, const render::Surroundings& mountains, int most_along) {
    if (!scenario.look.date) return {};
    return render::land_of(mountains, settlement_of(scenario), most_along);
}

render::Woods woods_on(const Scenario& scenario, const render::Surroundings& mountains,
                       const render::Land& land) {
    render::TreeRules rules = scenario.trees;
    rules.mixed = scenario.look.date.has_value();
    render::Woods woods(mountains, rules, scenario.datum, clearings_of(scenario), land);
    if (scenario.woods_act()) woods.let_act();
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

Backdrop backdrop_of(const Scenario& scenario) {
    Backdrop backdrop{mountains_around(scenario), {}, {}};
    backdrop.land = land_on(scenario, backdrop.mountains);
    backdrop.woods = woods_on(scenario, backdrop.mountains, backdrop.land);
    return backdrop;
}

}  // namespace game
