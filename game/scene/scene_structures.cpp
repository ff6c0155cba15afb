#include "game/scene/scene_structures.h"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "game/scene/structures.h"

namespace game {
namespace {

std::vector<TomlTable> at_most(std::size_t most, const char* name, TomlTable& root) {
    std::vector<TomlTable> found = root.tables(name);
    if (found.size() > most)
        root.blame(name, fmt::format("stands here {} times; at most {} are allowed", found.size(), most));
    return found;
}

void read_hut(TomlTable& table, render::Structures& structures, ThingsTables& things) {
    const auto at = table.place("at");
    if (!at) table.blame("", "needs `at`: metres east and north");
    const double heading = table.number("heading", -360, 360).value_or(0);
    table.finish();
    if (kStructuresAct)
        add_house(table, at.value_or(glm::dvec2(0)), heading, things);
    else
        structures.all.push_back({render::StructureKind::kHut, at.value_or(glm::dvec2(0)), heading});
}

void read_road(TomlTable& table, render::Structures& structures, ThingsTables& things) {
    render::Road road;
    auto points = table.places("points", 2, kMostRoadPoints);
    if (!points) table.blame("", "needs points: places that it leads through");
    road.points = std::move(points).value_or(std::vector<glm::dvec2>());
    if (const auto wrong = fault_of_road(road.points)) table.blame("points", *wrong);
    road.width_m = table.number("width", kNarrowestRoad, kWidestRoad).value_or(road.width_m);
    table.finish();
    if (kStructuresAct)
        add_road(table, road.points, road.width_m, things);
    else
        structures.roads.push_back(std::move(road));
}

void read_lift(TomlTable& table, render::Structures& structures, ThingsTables& things) {
    const auto from = table.place("from"), to = table.place("to");
    if (!from || !to) table.blame("", "needs `from` and `to`: places of its stations");
    table.finish();
    if (!from || !to) return;
    const auto wrong = fault_of_lift(*from, *to);
    if (wrong) table.blame("to", *wrong);
    if (wrong) return;
    if (kStructuresAct)
        add_lift(table, *from, *to, things);
    else
        add_lift(*from, *to, structures);
}

}  // namespace

render::Structures read_structures(TomlTable& root, ThingsTables& things) {
    render::Structures structures;
    for (TomlTable& table : at_most(kMostHuts, "hut", root)) read_hut(table, structures, things);
    for (TomlTable& table : at_most(kMostRoads, "road", root)) read_road(table, structures, things);
    for (TomlTable& table : at_most(kMostLifts, "lift", root)) read_lift(table, structures, things);
    return structures;
}

}  // namespace game
