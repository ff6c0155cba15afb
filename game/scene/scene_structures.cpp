#include "game/scene/scene_structures.h"

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

void read_hut(TomlTable& table, ThingsTables& things) {
    const auto at = table.place("at");
    if (!at) table.blame("", "needs `at`: metres east and north");
    const double heading = table.number("heading", -360, 360).value_or(0);
    table.finish();
    add_house(table, at.value_or(glm::dvec2(0)), heading, things);
}

void read_road(TomlTable& table, ThingsTables& things) {
    const auto points = table.places("points", 2, kMostRoadPoints);
    if (!points) table.blame("", "needs points: places that it leads through");
    const double width = table.number("width", kNarrowestRoad, kWidestRoad).value_or(render::Road().width_m);
    table.finish();
    if (!points) return;
    if (const auto wrong = fault_of_road(*points)) table.blame("points", *wrong);
    add_road(table, *points, width, things);
}

void read_lift(TomlTable& table, ThingsTables& things) {
    const auto from = table.place("from"), to = table.place("to");
    if (!from || !to) table.blame("", "needs `from` and `to`: places of its stations");
    table.finish();
    if (!from || !to) return;
    if (const auto wrong = fault_of_lift(*from, *to)) table.blame("to", *wrong);
    add_lift(table, *from, *to, things);
}

}  // namespace

void read_structures(TomlTable& root, ThingsTables& things) {
    for (TomlTable& table : at_most(kMostHuts, "hut", root)) read_hut(table, things);
    for (TomlTable& table : at_most(kMostRoads, "road", root)) read_road(table, things);
    for (TomlTable& table : at_most(kMostLifts, "lift", root)) read_lift(table, things);
}

}  // namespace game
