#include "game/session/world_now.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "game/base/limits.h"
#include "game/recording/chain.h"
#include "game/recording/format.h"
#include "game/scene/standing.h"
#include "sim/core/angle.h"

namespace game {
namespace {

template <class Value>
std::vector<Value> values_of(const sim::Field<Value>& field) {
    std::vector<Value> values;
    values.reserve(static_cast<std::size_t>(field.nx()) * static_cast<std::size_t>(field.ny()));
    for (int y = 0; y < field.ny(); ++y) values.insert(values.end(), field.row(y), field.row(y) + field.nx());
    return values;
}

template <class Value>
bool is_empty(const std::vector<Value>& values) {
    return std::ranges::all_of(values, [](const Value& value) { return value == Value{}; });
}

// Degrees of which direction_of() gives the front of an object, bit by bit if any do: the roundest of them.
double turn_of(const sim::Thing& thing) {
    const auto gives = [&](double degrees) {
        const sim::Direction front = sim::direction_of(degrees);
        return front.x == thing.front_x && front.y == thing.front_y;
    };
    const double about = thing.turn() + 0.0;  // 0, not −0
    for (const double parts : {1.0, 1e2, 1e4, 1e6, 1e9})
        if (const double rounded = std::rint(about * parts) / parts; gives(rounded)) return rounded;
    constexpr int kNeighbours = 64;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    double below = about, above = about;
    for (int i = 0; i < kNeighbours; ++i) {
        for (const double degrees : {below, above})
            if (gives(degrees)) return degrees;
        below = std::nextafter(below, -kInfinity), above = std::nextafter(above, kInfinity);
    }
    return about;
}

sim::Command line_between(sim::CommandKind kind, const sim::Thing& first, double to_x, double to_y) {
    sim::Command command;
    command.kind = kind;
    command.x = first.x, command.y = first.y;
    command.to_x = to_x, command.to_y = to_y;
    return command;
}

sim::Command house_of(const sim::Thing& thing) {
    sim::Command command;
    command.kind = sim::CommandKind::kHouse;
    command.x = thing.x, command.y = thing.y, command.turn = turn_of(thing);
    command.length = thing.length, command.width = thing.width, command.height = thing.height;
    command.strength = thing.strength;
    return command;
}

// The objects of a world as commands that place them again, and what that changes.
struct Objects {
    std::vector<sim::Command> placed;
    int cleared = 0, mended = 0;

    explicit Objects(std::span<const sim::Thing> list) {
        while (!list.empty()) {
            const auto end = std::ranges::find_if(
                list, [&](const sim::Thing& thing) { return thing.group != list.front().group; });
            const auto group = list.first(static_cast<std::size_t>(end - list.begin()));
            list = list.subspan(group.size());
            add(group);
        }
    }

  private:
    // What one command has built.
    void add(std::span<const sim::Thing> group) {
        const sim::Thing& first = group.front();
        switch (first.kind) {
            case sim::ThingKind::kNet:
                return add_nets(group);
            case sim::ThingKind::kRoad:
                for (const sim::Thing& piece : group) {
                    placed.push_back(line_between(sim::CommandKind::kRoad, piece, piece.to_x, piece.to_y));
                    placed.back().width = piece.width;
                }
                return;
            case sim::ThingKind::kHouse:
            case sim::ThingKind::kStation:
            case sim::ThingKind::kPylon:
                break;
        }
        if (std::ranges::any_of(group, &sim::Thing::destroyed)) {
            ++cleared;
            return;
        }
        mended += std::ranges::any_of(group, is_hurt);
        placed.push_back(first.kind == sim::ThingKind::kHouse
                             ? house_of(first)
                             : line_between(sim::CommandKind::kLift, first, group.back().x, group.back().y));
    }

    // The parts of a row between pieces that were destroyed.
    void add_nets(std::span<const sim::Thing> row) {
        while (!row.empty()) {
            const auto stand =
                static_cast<std::size_t>(std::ranges::find_if(row, &sim::Thing::destroyed) - row.begin());
            if (stand == 0) {
                ++cleared;
                row = row.subspan(1);
                continue;
            }
            const auto part = row.first(stand);
            row = row.subspan(stand);
            mended += static_cast<int>(std::ranges::count_if(part, is_hurt));
            placed.push_back(
                line_between(sim::CommandKind::kNet, part.front(), part.back().to_x, part.back().to_y));
            placed.back().height = part.front().height, placed.back().strength = part.front().strength;
        }
    }

    static bool is_hurt(const sim::Thing& thing) { return thing.damaged() || thing.under(); }
};

void take_things(const sim::Things& things, bool woods_act, Scenario::Standing& standing) {
    standing.forest = values_of(things.forest);
    if (!woods_act && is_empty(standing.forest)) standing.forest.clear();
    standing.earth = values_of(things.earth);
    if (is_empty(standing.earth)) standing.earth.clear();
    standing.water = values_of(things.water);
    if (is_empty(standing.water)) standing.water.clear();
    standing.placed = Objects(things.list).placed;
}

void take_mixture(const sim::Mixture& mixture, Scenario::Lower& lower) {
    take_numbers(mixture.lower, lower.params);
    lower.depth = values_of(mixture.untouched);
    lower.settled = values_of(mixture.settled);
    lower.rolling = values_of(mixture.rolling);
    if (is_empty(lower.settled)) lower.settled.clear();
    if (is_empty(lower.rolling)) lower.rolling.clear();
}

}  // namespace

Outcome<Scenario> scenario_of_now(const Scenario& initial, const sim::State& state) {
    if (initial.flow) return unusable("a flow demo has no world to save");
    if (initial.weather)
        return unusable(
            "a world with weather cannot be saved, because its weak layers would be lost; its recording "
            "can");
    Scenario now = initial;
    now.goal.reset();
    now.camera_path.clear();  // its times are those of the world before
    take_numbers(state.params, now.params);
    now.depth = values_of(state.depth);
    now.rolling = values_of(state.rolling);
    for (const std::vector<float>* layer : {&now.depth, &now.rolling})
        if (const float deepest = *std::ranges::max_element(*layer); deepest > sim::kDeepest / 2)
            return unusable(fmt::format("a layer is {:.1f} m deep, and a world starts with at most {:g} m",
                                        deepest, sim::kDeepest / 2));
    if (state.mixture) take_mixture(*state.mixture, *now.lower);
    if (state.things) take_things(*state.things, now.woods_act(), now.standing);
    if (now.standing.placed.size() > kMostPlaced)
        return unusable(fmt::format("{} objects stand, and a world starts with at most {}",
                                    now.standing.placed.size(), kMostPlaced));
    if (const auto wrong = fault_of_placed(now)) return unusable(wrong->fact);
    return now;
}

std::string recording_of(const Scenario& scenario) {
    Header header;
    header.scenario = scenario;
    Chain chain;
    std::string text = to_json(header).dump(-1, ' ', false, Json::error_handler_t::replace), end;
    chain.close(text);
    write(EndLine{0}, end);
    chain.close(end);
    return text + '\n' + end + '\n';
}

std::string not_kept(const sim::State& state) {
    std::string text;
    if (state.ledger.rolling > 0) text += ". What moves starts again from rest";
    if (!state.things) return text;
    const Objects objects(state.things->list);
    const auto counted = [](int count, const char* one, const char* many) {
        return count == 1 ? std::string(one) : fmt::format("{} {}", count, many);
    };
    if (objects.cleared > 0)
        text += fmt::format(". {} cleared away",
                            counted(objects.cleared, "A destroyed object is", "destroyed objects are"));
    if (objects.mended > 0)
        text += fmt::format(". {} whole again",
                            counted(objects.mended, "A damaged object is", "damaged objects are"));
    return text;
}

}  // namespace game
