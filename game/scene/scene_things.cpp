#include "game/scene/scene_things.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "game/base/limits.h"
#include "game/scene/mountains.h"
#include "game/scene/scene_trees.h"
#include "game/scene/standing.h"
#include "game/scene/structures.h"
#include "sim/core/angle.h"
#include "sim/world/disc.h"
#include "sim/world/thing_places.h"

namespace game {
namespace {

constexpr std::pair<std::string_view, double> kStrengths[] = {
    {"glass", 1}, {"wood", 5}, {"brick", 10}, {"concrete", 30}};  // kPa

// Discs of a dam overlap: their centres are at most this share of their radius apart.
constexpr double kApart = 0.5;
// The sum of such cones is at most this steep, per height and radius, and flanks of earth are at most 1 : 1.25.
constexpr double kSteepest = 1.33, kSteepestFlank = 1 / 1.25;

// Takes a number of the command, in the range that the manifest gives it, if the table has it.
void read_number(TomlTable& table, std::string_view key, sim::Command& into) {
    for (const sim::CommandNumber& number : sim::info_of(into.kind).numbers)
        if (number.name == key)
            into.*number.value = table.number(key, number.least, number.most).value_or(into.*number.value);
}

void read_strength(TomlTable& table, sim::Command& into) {
    if (!table.is_text("strength")) return read_number(table, "strength", into);
    const auto name = table.text("strength");
    const auto found = std::ranges::find(kStrengths, *name, &std::pair<std::string_view, double>::first);
    if (found == std::end(kStrengths))
        table.blame("strength", "is not a number of kPa, nor one of glass, wood, brick, concrete");
    else
        into.strength = found->second;
}

std::optional<std::vector<glm::dvec2>> read_points(TomlTable& table) {
    auto points = table.places("points", 2, kMostRoadPoints);
    if (!points && !table.has("points")) table.blame("", "needs points: places that it leads through");
    if (points)
        if (const auto wrong = fault_of_road(*points)) table.blame("points", *wrong);
    return points;
}

// Places it between each two points.
void place_along(const TomlTable& table, const std::optional<std::vector<glm::dvec2>>& points,
                 sim::Command piece, ThingsTables& things) {
    std::vector<sim::Command> commands;
    for (std::size_t i = 1; points && i < points->size(); ++i) {
        piece.x = (*points)[i - 1].x, piece.y = (*points)[i - 1].y;
        piece.to_x = (*points)[i].x, piece.to_y = (*points)[i].y;
        commands.push_back(piece);
    }
    things.placed.push_back({table, std::move(commands)});
}

void read_house(TomlTable& table, ThingsTables& things) {
    const auto at = table.place("at");
    if (!at && !table.has("at")) table.blame("", "needs `at`: metres east and north");
    sim::Command command = sim::usual_command(sim::CommandKind::kHouse);
    command.x = at.value_or(glm::dvec2(0)).x, command.y = at.value_or(glm::dvec2(0)).y;
    command.turn = table.number("heading", -360, 360).value_or(0);
    for (const char* key : {"length", "width", "height"}) read_number(table, key, command);
    read_strength(table, command);
    table.finish();
    things.placed.push_back({table, {command}});
}

void read_net(TomlTable& table, ThingsTables& things) {
    const auto points = read_points(table);
    sim::Command net = sim::usual_command(sim::CommandKind::kNet);
    read_number(table, "height", net);
    read_strength(table, net);
    table.finish();
    place_along(table, points, net, things);
}

// At most so many tables of a kind.
std::vector<TomlTable> at_most(std::size_t most, const char* name, TomlTable& root) {
    std::vector<TomlTable> found = root.tables(name);
    if (found.size() > most)
        root.blame(name, fmt::format("stands here {} times; at most {} are allowed", found.size(), most));
    return found;
}

void read_road(TomlTable& table, ThingsTables& things) {
    const auto points = read_points(table);
    sim::Command road = sim::usual_command(sim::CommandKind::kRoad);
    read_number(table, "width", road);
    table.finish();
    place_along(table, points, road, things);
}

void read_lift(TomlTable& table, ThingsTables& things) {
    const auto from = table.place("from"), to = table.place("to");
    if (!from || !to) table.blame("", "needs `from` and `to`: places of its stations");
    table.finish();
    if (!from || !to) return;
    if (const auto wrong = fault_of_lift(*from, *to)) table.blame("to", *wrong);
    place_along(table, std::vector{*from, *to}, sim::usual_command(sim::CommandKind::kLift), things);
}

// Cones of earth along a line, whose sum is `rise` high along its middle; toward its ends it grows lower.
std::vector<sim::Command> dam_along(const std::vector<glm::dvec2>& points, double radius, double rise) {
    std::vector<glm::dvec2> centres;
    std::vector<double> apart;  // from each centre to the next
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::dvec2 along = points[i] - points[i - 1];
        const double length = glm::length(along);
        const auto pieces = static_cast<std::size_t>(std::ceil(length / (kApart * radius)));
        if (centres.size() + pieces > kMostPlaced) return {};
        for (std::size_t k = 0; k < pieces; ++k) {
            centres.push_back(points[i - 1] + along * (static_cast<double>(k) / static_cast<double>(pieces)));
            apart.push_back(length / static_cast<double>(pieces));
        }
    }
    centres.push_back(points.back());
    apart.push_back(apart.back());
    std::vector<sim::Command> commands;
    for (std::size_t i = 0; i < centres.size(); ++i) {
        const double around = (apart[i] + apart[i == 0 ? 0 : i - 1]) / 2;
        sim::Command command;
        command.kind = sim::CommandKind::kSculpt;
        command.x = centres[i].x, command.y = centres[i].y;
        command.radius = radius;
        command.rise = rise * around / radius;
        command.profile = sim::Profile::kCone;
        commands.push_back(command);
    }
    return commands;
}

void read_dam(TomlTable& table, ThingsTables& things) {
    constexpr double kNarrowest = 1, kWidest = 500;  // m
    const auto points = read_points(table);
    const auto radius = table.number("radius", kNarrowest, kWidest);
    const auto rise = table.number("rise", -sim::kHighestEarth, sim::kHighestEarth);
    if (!radius && !table.has("radius"))
        table.blame("", "needs a radius: metres from its middle to its foot");
    if (!rise && !table.has("rise")) table.blame("", "needs a rise, in metres; below 0: a ditch");
    table.finish();
    if (!points || !radius || !rise) return;
    if (const double least = std::abs(*rise) * kSteepest / kSteepestFlank; *radius < least)
        table.blame("radius",
                    fmt::format("is {} m: its flanks would be steeper than 1 : 1.25; at least {:.1f} m "
                                "are needed for {} m of earth",
                                *radius, std::ceil(10 * least) / 10, *rise));
    auto commands = dam_along(*points, *radius, *rise);
    if (commands.empty())
        table.blame("points",
                    fmt::format("make more than {} strokes of earth; use a larger radius", kMostPlaced));
    things.placed.push_back({table, std::move(commands), *points});
}

void read_forest(TomlTable& table, ThingsTables& things) {
    auto polygon = table.places("polygon", kFewestTreeCorners, kMostTreeCorners);
    if (!polygon && !table.has("polygon")) table.blame("", "needs a polygon: places around it, in order");
    if (polygon)
        if (const auto sides = crossing_sides(*polygon))
            table.blame("polygon", fmt::format("crosses itself: side {}, from corner {}, meets side {}",
                                               sides->first, sides->first, sides->second));
    sim::Command planted = sim::usual_command(sim::CommandKind::kPlant);
    for (const char* key : {"stems", "diameter", "height"}) read_number(table, key, planted);
    table.finish();
    things.forests.push_back({table,
                              std::move(polygon).value_or(std::vector<glm::dvec2>()),
                              {static_cast<std::uint16_t>(std::lround(planted.stems)), 0,
                               static_cast<std::uint8_t>(std::lround(100 * planted.diameter)),
                               static_cast<std::uint8_t>(std::lround(planted.height))}});
}

// Gives a cone of earth the volume that it has on a fine grid, so that a dam costs as much on any.
void fit_to_grid(sim::Command& cone, const sim::Grid& grid) {
    const auto dx = static_cast<double>(grid.dx);
    const double exact = std::numbers::pi / 3 * cone.radius * cone.radius;
    cone.rise *= exact / (sim::Disc(cone, dx).total_weight(dx, cone.profile) * dx * dx);
}

glm::dvec2 extent_of(const sim::Grid& grid) {
    return glm::dvec2(grid.nx - 1, grid.ny - 1) * static_cast<double>(grid.dx);
}

std::optional<std::string> fault_of_places(std::string_view what, const std::vector<glm::dvec2>& places,
                                           const sim::Grid& grid) {
    const glm::dvec2 size = extent_of(grid);
    for (std::size_t i = 0; i < places.size(); ++i)
        if (const glm::dvec2 at = places[i]; at.x < 0 || at.x > size.x || at.y < 0 || at.y > size.y)
            return fmt::format("has {} {}, {:.6g}, {:.6g}, beside the grid, which is {:.6g} × {:.6g} m", what,
                               i + 1, at.x, at.y, size.x, size.y);
    return std::nullopt;
}

// Where the sides of a polygon cross a line to the east, from west to east. A place on it is inside if it has an odd
// number of them to its east.
std::vector<double> crossings_at(const std::vector<glm::dvec2>& polygon, double north) {
    std::vector<double> east;
    for (std::size_t i = 0, before = polygon.size() - 1; i < polygon.size(); before = i++) {
        const glm::dvec2 a = polygon[before], b = polygon[i];
        if ((a.y > north) != (b.y > north)) east.push_back(a.x + (b.x - a.x) * (north - a.y) / (b.y - a.y));
    }
    std::ranges::sort(east);
    return east;
}

// Rows of the grid that a polygon reaches into.
std::pair<int, int> rows_of(const std::vector<glm::dvec2>& polygon, const sim::Grid& grid) {
    const auto [south, north] = std::ranges::minmax(polygon, {}, &glm::dvec2::y);
    const auto row = [&](double metres) {
        return std::clamp(static_cast<int>(metres / static_cast<double>(grid.dx)), 0, grid.ny - 1);
    };
    return {row(south.y), std::min(row(north.y) + 1, grid.ny - 1)};
}

// Vertices that may be visited before tick 0 by one kind of work, as by commands of things.
std::int64_t most_visits_before(const sim::Grid& grid) {
    return std::max(sim::kAlwaysVisitsBefore, sim::kMostVisits * static_cast<std::int64_t>(grid.size()));
}

// Vertices and sides that planting a forest visits.
std::int64_t visits_of(const std::vector<glm::dvec2>& polygon, const sim::Grid& grid) {
    const auto [first, last] = rows_of(polygon, grid);
    return (last - first + std::int64_t{1}) * (grid.nx + static_cast<std::int64_t>(polygon.size()));
}

// Plants the vertices inside its polygon, row by row. Where two forests meet, the later one grows.
void plant_forest(ThingsTables::Forest& forest, Scenario& scenario) {
    const sim::Grid& grid = scenario.grid;
    if (forest.polygon.empty()) return;  // it has been blamed
    if (const auto wrong = fault_of_places("corner", forest.polygon, grid)) {
        forest.table.blame("polygon", *wrong);
        return;
    }
    std::vector<sim::Stems>& stems = scenario.standing.forest;
    stems.resize(grid.size());
    bool any = false;
    const auto [first, last] = rows_of(forest.polygon, grid);
    for (int y = first; y <= last; ++y) {
        const std::vector<double> crossings = crossings_at(forest.polygon, y * static_cast<double>(grid.dx));
        if (crossings.empty()) continue;
        std::size_t passed = 0;  // crossings that are not to the east
        std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.nx);
        for (int x = 0; x < grid.nx && passed < crossings.size(); ++x, ++i) {
            while (passed < crossings.size() && !(x * static_cast<double>(grid.dx) < crossings[passed]))
                ++passed;
            if ((crossings.size() - passed) % 2 != 0 && scenario.has_data[i] != 0)
                stems[i] = forest.stems, any = true;
        }
    }
    if (!any)
        forest.table.blame(
            "polygon", fmt::format("has no vertex of the grid inside, whose cells are {:.4g} m", grid.dx));
}

// The trees on the grid become a forest.
void let_woods_act(Scenario& scenario) {
    const render::Surroundings mountains = mountains_around(scenario);
    const render::Woods woods = woods_on(scenario, mountains);
    scenario.standing.forest = render::forest_of(woods, scenario.grid);
}

// Squares of a road's width that cover it, half a cell apart.
int squares_along(const sim::Command& road, const sim::Grid& grid) {
    const double length = glm::distance(glm::dvec2(road.x, road.y), glm::dvec2(road.to_x, road.to_y));
    return static_cast<int>(std::ceil(2 * length / static_cast<double>(grid.dx))) + 1;
}

// The first road up to which clearing them of stems visits more vertices than commands before tick 0 may.
std::optional<std::size_t> first_unclearable(const Scenario& scenario) {
    double visits = 0;
    const std::vector<sim::Command>& placed = scenario.standing.placed;
    for (std::size_t i = 0; i < placed.size(); ++i) {
        if (placed[i].kind != sim::CommandKind::kRoad) continue;
        const double across = placed[i].width / static_cast<double>(scenario.grid.dx) + 1;
        visits += squares_along(placed[i], scenario.grid) * across * across;
        if (visits > static_cast<double>(sim::kAlwaysVisitsBefore)) return i;
    }
    return std::nullopt;
}

// No stems stand in a house or on a road.
void clear_built(Scenario& scenario) {
    const sim::Grid& grid = scenario.grid;
    std::vector<sim::Stems>& forest = scenario.standing.forest;
    if (forest.empty()) return;
    const auto clear = [&](sim::Thing thing) {
        for (const std::int32_t vertex : sim::footprint_of(thing, grid))
            forest[static_cast<std::size_t>(vertex)] = {};
    };
    for (const sim::Command& each : scenario.standing.placed) {
        const glm::dvec2 from(each.x, each.y), to(each.to_x, each.to_y);
        if (each.kind == sim::CommandKind::kHouse) {
            const sim::Direction front = sim::direction_of(each.turn);
            clear({.x = each.x,
                   .y = each.y,
                   .front_x = front.x,
                   .front_y = front.y,
                   .length = each.length,
                   .width = each.width});
        } else if (each.kind == sim::CommandKind::kRoad) {
            const int steps = squares_along(each, grid);
            for (int i = 0; i <= steps; ++i) {
                const glm::dvec2 at = glm::mix(from, to, static_cast<double>(i) / steps);
                clear({.x = at.x, .y = at.y, .length = each.width, .width = each.width});
            }
        }
    }
}

}  // namespace

ThingsTables read_things(TomlTable& root) {
    ThingsTables things;
    // Earth first, because the rest stands on it.
    for (TomlTable& table : root.tables("dam")) read_dam(table, things);
    for (TomlTable& table : root.tables("house")) read_house(table, things);
    for (TomlTable& table : root.tables("net")) read_net(table, things);
    for (TomlTable& table : at_most(kMostRoads, "road", root)) read_road(table, things);
    for (TomlTable& table : at_most(kMostLifts, "lift", root)) read_lift(table, things);
    for (TomlTable& table : root.tables("forest")) read_forest(table, things);
    if (auto earth = root.table("earth")) {
        const auto budget = earth->number("budget", 0, kGreatestEarthBudget);
        if (!budget && !earth->has("budget")) earth->blame("", "needs a budget, in m³");
        things.earth_budget = budget.value_or(-1);
        earth->finish();
        things.earth = *earth;
    }
    return things;
}

void stand(ThingsTables things, bool woods_act, Scenario& scenario) {
    Scenario::Standing& standing = scenario.standing;
    standing.earth_budget = things.earth_budget;
    std::vector<TomlTable*> origin;  // of each command
    for (ThingsTables::Placed& each : things.placed) {
        if (standing.placed.size() + each.commands.size() > kMostPlaced) {
            each.table.blame("",
                             fmt::format("is too many: at most {} pieces may stand in a scene", kMostPlaced));
            return;
        }
        if (const auto wrong = fault_of_places("point", each.points, scenario.grid))
            each.table.blame("points", *wrong);
        for (sim::Command& command : each.commands) {
            if (command.kind == sim::CommandKind::kSculpt) fit_to_grid(command, scenario.grid);
            standing.placed.push_back(command);
            origin.push_back(&each.table);
        }
    }
    if (woods_act) let_woods_act(scenario);
    std::int64_t visits = 0;
    for (ThingsTables::Forest& forest : things.forests) {
        if (!forest.polygon.empty()) visits += visits_of(forest.polygon, scenario.grid);
        if (visits > most_visits_before(scenario.grid)) {
            forest.table.blame(
                "polygon",
                fmt::format("is too much forest: up to it {} vertices would be visited, and the most is {}",
                            visits, most_visits_before(scenario.grid)));
            break;
        }
        plant_forest(forest, scenario);
    }
    if (const auto road = first_unclearable(scenario); road && !standing.forest.empty()) {
        origin[*road]->blame(
            "", fmt::format("is too much road for this grid: clearing all roads of trees takes over {} "
                            "vertices; use narrower or shorter roads",
                            sim::kAlwaysVisitsBefore));
        return;
    }
    clear_built(scenario);
    if (const auto wrong = fault_of_placed(scenario)) {
        origin[wrong->index]->blame("", "cannot stand: " + wrong->fact);
        return;
    }
    if (!things.earth) return;
    if (const double needed = earth_needed(scenario); needed > standing.earth_budget)
        things.earth->blame("budget", fmt::format("is {:.1f} m³, and the scene's own [[dam]] needs {:.1f} m³",
                                                  standing.earth_budget, needed));
}

}  // namespace game
