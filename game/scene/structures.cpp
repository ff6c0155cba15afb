#include "game/scene/structures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace game {
namespace {

using render::Structure;
using render::StructureKind;
using render::StructureState;

constexpr double kPylonsApart = 80;   // m, about
constexpr double kFullLoadDepth = 1;  // m, of a flow that presses on all of a wall

double strength_kpa(StructureKind kind) {
    switch (kind) {
        case StructureKind::kHut:
            return 5;
        case StructureKind::kStation:
            return 10;
        default:
            break;
    }
    return 100;
}

const char* name_of(StructureKind kind) {
    switch (kind) {
        case StructureKind::kHut:
            return "hut";
        case StructureKind::kStation:
            return "station";
        default:
            break;
    }
    return "pylon";
}

// Half of its length and of its width as vectors, m.
std::pair<glm::dvec2, glm::dvec2> half_axes(const Structure& structure) {
    const double heading = glm::radians(structure.heading_deg);
    const glm::dvec2 front(std::sin(heading), std::cos(heading)), right(front.y, -front.x);
    const glm::dvec2 half = render::half_footprint(structure);
    return {half.x * front, half.y * right};
}

// Middle and corners of what stands on the ground, m.
std::array<glm::dvec2, 5> footprint(const Structure& structure) {
    const auto [front, right] = half_axes(structure);
    const glm::dvec2 at = structure.at;
    return {at, at - front - right, at + front - right, at + front + right, at - front + right};
}

// Whether two rectangles have a place in common: no axis of either separates them.
bool overlap(const Structure& a, const Structure& b) {
    const auto [af, ar] = half_axes(a);
    const auto [bf, br] = half_axes(b);
    const glm::dvec2 apart = b.at - a.at;
    for (const glm::dvec2& side : {af, ar, bf, br}) {
        const glm::dvec2 axis = glm::normalize(side);
        const auto reach = [&](const glm::dvec2& half) { return std::abs(glm::dot(half, axis)); };
        if (std::abs(glm::dot(apart, axis)) >= reach(af) + reach(ar) + reach(bf) + reach(br)) return false;
    }
    return true;
}

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

double surface_at(const sim::View& world, glm::dvec2 at) {
    return between(world.grid, at, [&](int x, int y) {
        return world.bedrock(x, y) + world.depth(x, y) + world.rolling(x, y);
    });
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
void add_road_piece(glm::dvec2 from, glm::dvec2 to, double width, std::span<render::Road> of_things,
                    std::vector<render::Road>& roads) {
    constexpr std::size_t kLatest = 8;
    for (render::Road& road : of_things.last(std::min(of_things.size(), kLatest)))
        if (road.width_m == width && road.points.back() == from) {
            road.points.push_back(to);
            return;
        }
    roads.push_back({{from, to}, width});
}

// What is wrong with a place, or nothing.
const char* fault_of_place(glm::dvec2 at, const sim::Grid& grid, std::span<const std::uint8_t> has_data) {
    const glm::dvec2 cell = at / static_cast<double>(grid.dx);
    if (!(cell.x >= 0 && cell.y >= 0 && cell.x <= grid.nx - 1 && cell.y <= grid.ny - 1))
        return "outside the terrain";
    const int x = std::min(static_cast<int>(cell.x), grid.nx - 2),
              y = std::min(static_cast<int>(cell.y), grid.ny - 2);
    for (const auto& [i, j] : {std::pair{x, y}, {x + 1, y}, {x, y + 1}, {x + 1, y + 1}})
        if (has_data[static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.nx) +
                     static_cast<std::size_t>(i)] == 0)
            return "where the terrain has no data";
    return nullptr;
}

}  // namespace

std::optional<std::string> fault_of_road(std::span<const glm::dvec2> points) {
    if (std::adjacent_find(points.begin(), points.end()) == points.end()) return std::nullopt;
    return "has the same place twice in a row";
}

std::optional<std::string> fault_of_lift(glm::dvec2 valley, glm::dvec2 mountain) {
    const double length = glm::distance(valley, mountain);
    if (length >= kShortestLift && length <= kLongestLift) return std::nullopt;
    return fmt::format("is {:.0f} m away; {:.0f} to {:.0f} m are allowed", length, kShortestLift,
                       kLongestLift);
}

void add_lift(glm::dvec2 valley, glm::dvec2 mountain, render::Structures& structures) {
    const glm::dvec2 along = mountain - valley;
    const double length = glm::length(along), heading = glm::degrees(std::atan2(along.x, along.y));
    const int spans = std::max(1, static_cast<int>(std::lround(length / kPylonsApart)));
    structures.lifts.push_back({structures.all.size(), static_cast<std::size_t>(spans) + 1});
    for (int i = 0; i <= spans; ++i) {
        const bool end = i == 0 || i == spans;
        const double t = static_cast<double>(i) / spans;
        const glm::dvec2 at = i == spans ? mountain : valley + t * along;
        structures.all.push_back({end ? StructureKind::kStation : StructureKind::kPylon, at, heading});
    }
}

std::pair<glm::dvec2, glm::dvec2> stations(const render::Structures& structures, const render::Lift& lift) {
    return {structures.all[lift.first].at, structures.all[lift.first + lift.count - 1].at};
}

std::optional<std::string> fault_of(const render::Structures& structures, const sim::Grid& grid,
                                    std::span<const std::uint8_t> has_data) {
    const auto name = [&](std::size_t i) {
        const Structure& each = structures.all[i];
        const auto same_kind = [&](const Structure& other) { return other.kind == each.kind; };
        const auto number =
            1 + std::count_if(structures.all.begin(), structures.all.begin() + static_cast<std::ptrdiff_t>(i),
                              same_kind);
        return fmt::format("{} {} at ({:.0f}, {:.0f})", name_of(each.kind), number, each.at.x, each.at.y);
    };
    for (std::size_t i = 0; i < structures.all.size(); ++i) {
        for (const glm::dvec2& at : footprint(structures.all[i]))
            if (const char* fault = fault_of_place(at, grid, has_data))
                return fmt::format("{} is {}", name(i), fault);
        for (std::size_t k = 0; k < i; ++k)
            if (overlap(structures.all[i], structures.all[k]))
                return fmt::format("{} stands on {}", name(i), name(k));
    }
    for (std::size_t i = 0; i < structures.roads.size(); ++i)
        for (const glm::dvec2& at : structures.roads[i].points)
            if (const char* fault = fault_of_place(at, grid, has_data))
                return fmt::format("point ({:.0f}, {:.0f}) of road {} is {}", at.x, at.y, i + 1, fault);
    return std::nullopt;
}

void add_things(const sim::View& world, std::span<const float> first_depth, render::Structures& into) {
    if (!world.things) return;
    const std::vector<sim::Thing>& list = world.things->list;
    const std::size_t first_road = into.roads.size();
    for (std::size_t i = 0; i < list.size(); ++i) {
        const sim::Thing& thing = list[i];
        const StructureState state = state_of(thing, world, first_depth);
        const glm::dvec2 at(thing.x, thing.y), to(thing.to_x, thing.to_y);
        switch (thing.kind) {
            case sim::ThingKind::kHouse:
                into.all.push_back({StructureKind::kHouse, at, thing.turn(), state, thing.length, thing.width,
                                    thing.height, render::material_of(thing.strength)});
                break;
            case sim::ThingKind::kStation:
            case sim::ThingKind::kPylon: {
                const bool goes_on = i > 0 && list[i - 1].group == thing.group;
                if (!goes_on) into.lifts.push_back({into.all.size(), 0, true});
                ++into.lifts.back().count;
                const bool pylon = thing.kind == sim::ThingKind::kPylon;
                into.all.push_back(
                    {pylon ? StructureKind::kPylon : StructureKind::kStation, at, thing.turn(), state});
                break;
            }
            case sim::ThingKind::kNet:
                into.nets.push_back({at, to, thing.height, state});
                break;
            case sim::ThingKind::kRoad:
                add_road_piece(at, to, thing.width, std::span(into.roads).subspan(first_road), into.roads);
                break;
        }
    }
}

StructureWatch::StructureWatch(const render::Structures& structures, const sim::View& world)
    : views_(structures) {
    first_depth_.reserve(world.grid.size());
    for (int y = 0; y < world.grid.ny; ++y)
        first_depth_.insert(first_depth_.end(), world.depth.row(y), world.depth.row(y) + world.grid.nx);
    structures_ = views_;
    add_things(world, first_depth_, structures_);
    for (const Structure& each : structures.all) first_surface_.push_back(surface_at(world, each.at));
}

void StructureWatch::watch(const sim::View& world, std::span<const float> pressure,
                           std::span<const float> depth) {
    const auto load = [&](int x, int y) {
        const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(world.grid.nx) +
                       static_cast<std::size_t>(x);
        return static_cast<double>(pressure[i]) *
               std::min(1.0, static_cast<double>(depth[i]) / kFullLoadDepth);
    };
    for (std::size_t i = 0; i < views_.all.size(); ++i) {
        Structure& each = views_.all[i];
        double most = 0;
        if (!pressure.empty())
            for (const glm::dvec2& at : footprint(each)) most = std::max(most, between(world.grid, at, load));
        const double share = most / strength_kpa(each.kind);
        const bool under = surface_at(world, each.at) - first_surface_[i] >= render::height_of(each);
        each.state = share >= 1     ? StructureState::kDestroyed
                     : under        ? StructureState::kBuried
                     : share >= 0.5 ? StructureState::kDamaged
                                    : StructureState::kIntact;
    }
    // Made anew only if things came or went, because the points of roads need memory.
    const std::int64_t changed = world.things ? world.things->changed : -1;
    if (changed == changed_) return take_states(world);
    changed_ = changed;
    structures_ = views_;
    add_things(world, first_depth_, structures_);
}

// Sets the states alone. Things have the order of their list, after the views.
void StructureWatch::take_states(const sim::View& world) {
    auto next = structures_.all.begin();
    for (const Structure& view : views_.all) (next++)->state = view.state;
    if (!world.things) return;
    auto next_net = structures_.nets.begin() + static_cast<std::ptrdiff_t>(views_.nets.size());
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
