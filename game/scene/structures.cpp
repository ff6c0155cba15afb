#include "game/scene/structures.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "sim/world/command.h"

namespace game {
namespace {

using render::Structure;
using render::StructureKind;
using render::StructureState;

// A field's value between vertices.
template <class Value>
double between(const sim::Grid& grid, glm::dvec2 at, const Value& value) {
    const glm::dvec2 cell =
        glm::clamp(at / static_cast<double>(grid.dx), glm::dvec2(0), glm::dvec2(grid.nx - 1, grid.ny - 1));
    const int x = std::min(static_cast<int>(cell.x), grid.nx - 2),
              y = std::min(static_cast<int>(cell.y), grid.ny - 2);
    const double u = cell.x - x, v = cell.y - y;
    const auto z = [&](int i, int j) { return static_cast<double>(value(i, j)); };
    return std::lerp(std::lerp(z(x, y), z(x + 1, y), u), std::lerp(z(x, y + 1), z(x + 1, y + 1), u), v);
}

// What became of a thing. It is buried only while something lies or rolls above it.
StructureState state_of(const sim::Thing& thing, const sim::View& world, std::span<const float> first_depth) {
    if (thing.destroyed()) return StructureState::kDestroyed;
    const bool line = thing.is_line();
    const glm::dvec2 from(thing.x, thing.y), to(thing.to_x, thing.to_y), at = line ? 0.5 * (from + to) : from;
    const double above = between(world.grid, at, [&](int x, int y) {
        const float first =
            first_depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(world.grid.nx) +
                        static_cast<std::size_t>(x)];
        return world.depth(x, y) + world.rolling(x, y) - first;
    });
    if (thing.kind != sim::ThingKind::kRoad && above >= thing.height) return StructureState::kBuried;
    return thing.damaged() ? StructureState::kDamaged : StructureState::kIntact;
}

// Lengthens one of the latest roads, if it ends where the piece begins, or begins another one.
void add_road_piece(glm::dvec2 from, glm::dvec2 to, double width, std::vector<render::Road>& roads) {
    constexpr std::size_t kLatest = 8;
    for (render::Road& road : std::span(roads).last(std::min(roads.size(), kLatest)))
        if (road.width_m == width && road.points.back() == from) {
            road.points.push_back(to);
            return;
        }
    roads.push_back({{from, to}, width});
}

}  // namespace

std::optional<std::string> fault_of_road(std::span<const glm::dvec2> points) {
    if (std::adjacent_find(points.begin(), points.end()) == points.end()) return std::nullopt;
    return "has the same place twice in a row";
}

std::optional<std::string> fault_of_lift(glm::dvec2 valley, glm::dvec2 mountain) {
    const double length = glm::distance(valley, mountain);
    if (length >= sim::kShortestLift && length <= sim::kLongestLine) return std::nullopt;
    return fmt::format("is {:.0f} m away; {:.0f} to {:.0f} m are allowed", length, sim::kShortestLift,
                       sim::kLongestLine);
}

render::Structures structures_in(const sim::View& world, std::span<const float> first_depth) {
    render::Structures structures;
    if (!world.things) return structures;
    const std::vector<sim::Thing>& list = world.things->list;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const sim::Thing& thing = list[i];
        const StructureState state = state_of(thing, world, first_depth);
        const glm::dvec2 at(thing.x, thing.y), to(thing.to_x, thing.to_y);
        switch (thing.kind) {
            case sim::ThingKind::kHouse:
                structures.all.push_back({StructureKind::kHouse, at, thing.turn(), state, thing.length,
                                          thing.width, thing.height, render::material_of(thing.strength)});
                break;
            case sim::ThingKind::kStation:
            case sim::ThingKind::kPylon: {
                const bool goes_on = i > 0 && list[i - 1].group == thing.group;
                if (!goes_on) structures.lifts.push_back({structures.all.size(), 0});
                ++structures.lifts.back().count;
                const bool pylon = thing.kind == sim::ThingKind::kPylon;
                structures.all.push_back(
                    {pylon ? StructureKind::kPylon : StructureKind::kStation, at, thing.turn(), state});
                break;
            }
            case sim::ThingKind::kNet:
                structures.nets.push_back({at, to, thing.height, state});
                break;
            case sim::ThingKind::kRoad:
                add_road_piece(at, to, thing.width, structures.roads);
                break;
        }
    }
    return structures;
}

StructureWatch::StructureWatch(const sim::View& world) {
    first_depth_.reserve(world.grid.size());
    for (int y = 0; y < world.grid.ny; ++y)
        first_depth_.insert(first_depth_.end(), world.depth.row(y), world.depth.row(y) + world.grid.nx);
    watch(world);
}

void StructureWatch::watch(const sim::View& world) {
    // Made anew only if things came or went, because the points of roads need memory.
    const std::int64_t changed = world.things ? world.things->changed : -1;
    if (changed == changed_) return take_states(world);
    changed_ = changed;
    structures_ = structures_in(world, first_depth_);
}

// Sets the states alone. Things have the order of their list.
void StructureWatch::take_states(const sim::View& world) {
    if (!world.things) return;
    auto next = structures_.all.begin();
    auto next_net = structures_.nets.begin();
    for (const sim::Thing& thing : world.things->list) {
        if (thing.kind == sim::ThingKind::kRoad) continue;
        const StructureState state = state_of(thing, world, first_depth_);
        if (thing.kind == sim::ThingKind::kNet)
            (next_net++)->state = state;
        else
            (next++)->state = state;
    }
}

}  // namespace game
