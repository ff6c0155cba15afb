#include "game/recording/things_json.h"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "game/recording/command_json.h"
#include "game/recording/ground_data.h"
#include "game/scene/standing.h"

namespace game::values {
namespace {

Json placed_json(std::span<const sim::Command> placed) {
    Json json = Json::array();
    for (const sim::Command& command : placed) {
        std::string text(1, '{');
        write(command, text);
        json.push_back(Json::parse(text + "}"));
    }
    return json;
}

sim::Command placed_from(const Json& json) {
    const sim::CommandInfo* const info = json.is_object() ? kind_in(json) : nullptr;
    if (!info) refuse("placed has something of unknown kind");
    if (!places_things(info->kind)) refuse(fmt::format("placed has a {}", info->name));
    return command_from(json, *info);
}

}  // namespace

Json things_json(const Scenario& scenario) {
    const Scenario::Standing& standing = scenario.standing;
    Json json = Json::object();
    if (!standing.forest.empty()) json["forest"] = pack_forest(standing.forest);
    if (!standing.placed.empty()) json["placed"] = placed_json(standing.placed);
    if (standing.earth_budget >= 0) json["earth_budget"] = standing.earth_budget;
    if (!standing.earth.empty()) json["earth"] = pack_metres(standing.earth);
    if (!standing.water.empty()) json["water"] = pack_metres(standing.water);
    return json;
}

void things_from(const Json& json, Scenario& scenario) {
    if (!json.is_object()) refuse("things is not an object");
    Scenario::Standing& standing = scenario.standing;
    if (json.contains("forest")) {
        auto forest = unpack_forest(text(json, "forest"), scenario.grid.size());
        if (!forest) refuse("things: " + forest.error());
        standing.forest = std::move(*forest);
    }
    for (const Json& each : list(json, "placed", kMostPlaced)) standing.placed.push_back(placed_from(each));
    if (json.contains("earth_budget"))
        standing.earth_budget = number(json, "earth_budget", 0, kGreatestEarthBudget);
    if (json.contains("earth")) {
        auto earth = unpack_metres(text(json, "earth"), scenario.grid.size());
        if (!earth) refuse("things: earth: " + earth.error());
        standing.earth = std::move(*earth);
        if (const auto wrong = fault_of_earth(scenario)) refuse("things: " + *wrong);
    }
    if (json.contains("water")) {
        auto water = unpack_metres(text(json, "water"), scenario.grid.size());
        if (!water) refuse("things: water: " + water.error());
        standing.water = std::move(*water);
        if (const auto wrong = fault_of_water(scenario)) refuse("things: " + *wrong);
    }
    if (const auto wrong = fault_of_placed(scenario)) refuse("things: " + wrong->fact);
}

}  // namespace game::values
