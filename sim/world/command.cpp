#include "sim/world/command.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>

#include "sim/core/check.h"
#include "sim/core/number_text.h"
#include "sim/world/edit_layers.h"
#include "sim/world/on_ground.h"
#include "sim/world/params.h"
#include "sim/world/quanta.h"
#include "sim/world/state.h"
#include "sim/world/thing_places.h"

namespace sim {
namespace {

// This tick's share of an amount of quanta that is spread over `ticks`, in whole ones, so that the shares add
// up exactly.
std::int64_t quanta_due(double amount, std::int64_t tick, std::int64_t ticks) {
    const double quanta = std::min(amount, 1e15);  // more than any layer takes, and still a whole number
    const auto until = [&](std::int64_t k) {
        return std::llrint(quanta * (static_cast<double>(k) / static_cast<double>(ticks)));
    };
    return until(tick + 1) - until(tick);
}

void pour(State& s, const Command& c, std::int64_t tick, std::int64_t ticks, double tick_s) {
    const Disc disc(c, s.grid.dx);
    const double total = disc.total_weight(s.grid.dx, c.profile);
    const double volume = c.rate * tick_s * static_cast<double>(ticks);
    each_ground(s, c, c.profile, [&](int x, int y, double w) {
        const auto due = quanta_due(volume * w / (total * s.grid.cell_area()) / kQuantum, tick, ticks);
        const float layer = c.layer == Layer::kStanding ? s.depth(x, y) : s.rolling(x, y);
        const auto room = static_cast<std::int64_t>(room_in(layer) / kQuantum);
        const auto quanta = std::clamp<std::int64_t>(due, 0, room);
        pour_at(s, x, y, c.layer, c.of, static_cast<float>(quanta) * kQuantum);
    });
}

void dig(State& s, const Command& c, std::int64_t tick, std::int64_t ticks, double tick_s) {
    const double depth = c.rate * tick_s * static_cast<double>(ticks);
    const auto due = static_cast<float>(std::min<std::int64_t>(
        quanta_due(depth / kQuantum, tick, ticks), static_cast<std::int64_t>(kDeepest / kQuantum)));
    each_ground(s, c, Profile::kDisc, [&](int x, int y, double) {
        const float wanted = due * kQuantum;
        const float from_rolling = std::min(wanted, s.rolling(x, y));
        const float from_depth = std::min(wanted - from_rolling, s.depth(x, y));
        dig_at(s, x, y, from_rolling, from_depth);
    });
}

void blast(State& s, const Command& c) {
    const auto most = [&](int x, int y) {
        const float hold = s.things ? held_share(*s.things, x, y, s.depth(x, y)) : 0;
        return nearest_quanta(static_cast<float>(c.depth) * (1 - hold));
    };
    each_ground(s, c, Profile::kDisc, [&](int x, int y, double) {
        start_at(s, x, y, std::min({most(x, y), s.depth(x, y), room_in(s.rolling(x, y))}));
    });
}

void settle(State& s, const Command& c) {
    each_ground(s, c, Profile::kDisc, [&](int x, int y, double) {
        settle_at(s, x, y, std::min(s.rolling(x, y), room_in(s.depth(x, y))));
    });
}

// m changes by rate·t/(n d). What the soil cannot take runs off, and so does all water on bare rock. If a place from which
// wet soil was taken is drained, it dries at once.
void soak(State& s, const Command& c, std::int64_t tick, std::int64_t ticks, double tick_s) {
    const bool drains = c.kind == CommandKind::kDrain;
    if (drains && !s.things) return;
    Things& t = things_of(s);
    const double rain = c.rate * tick_s * static_cast<double>(ticks);
    each_ground(s, c, c.profile, [&](int x, int y, double w) {
        const auto depth = static_cast<double>(s.depth(x, y));
        float& m = t.water(x, y);
        if (depth == 0) {
            if (drains) m = 0;
            return;
        }
        constexpr auto kAll = static_cast<std::int64_t>(1 / kWaterQuantum);
        const auto due =
            quanta_due(rain * w / (kPorosity * depth) / static_cast<double>(kWaterQuantum), tick, ticks);
        const float change = static_cast<float>(std::min(due, kAll)) * kWaterQuantum;
        m = drains ? std::max(m - change, 0.f) : std::min(m + change, 1.f);
    });
    t.unhashed = true;
}

template <class Value, class Infos>
std::optional<Value> found(const Infos& names, std::string_view name) {
    for (const auto& [value, known] : names)
        if (known == name) return value;
    return std::nullopt;
}

// What is wrong with the members that a kind does not use. Compared as bits: -0 is hashed as another number
// than 0.
std::optional<std::string> fault_of_unused(const Command& command, const CommandInfo& info) {
    const Command defaults;
    const auto is_used = [&](double Command::*member) {
        return std::any_of(info.numbers.begin(), info.numbers.end(),
                           [&](const CommandNumber& number) { return number.value == member; });
    };
    const auto is_default = [&](double Command::*member) {
        return std::bit_cast<std::uint64_t>(command.*member) ==
               std::bit_cast<std::uint64_t>(defaults.*member);
    };
    bool kept = (info.has_layer || command.layer == defaults.layer) &&
                (info.has_profile || command.profile == defaults.profile) &&
                (info.has_part || command.of == defaults.of) &&
                (info.has_param || command.param == defaults.param) &&
                (info.has_slope || (is_default(&Command::least_slope) && is_default(&Command::most_slope)));
    for (const CommandInfo& other : kCommands)
        for (const CommandNumber& number : other.numbers)
            kept = kept && (is_used(number.value) || is_default(number.value));
    if (kept) return std::nullopt;
    return std::string(info.name) + " has a member that only other commands have";
}

constexpr std::pair<Layer, std::string_view> kLayers[] = {{Layer::kRolling, "rolling"},
                                                          {Layer::kStanding, "standing"}};
constexpr std::pair<Profile, std::string_view> kProfiles[] = {{Profile::kDisc, "disc"},
                                                              {Profile::kCone, "cone"}};
constexpr std::pair<Part, std::string_view> kParts[] = {{Part::kUpper, "upper"}, {Part::kLower, "lower"}};

}  // namespace

const CommandInfo& info_of(CommandKind kind) {
    return kCommands[static_cast<std::size_t>(kind)];
}

Command usual_command(CommandKind kind) {
    Command command;
    command.kind = kind;
    for (const CommandNumber& number : info_of(kind).numbers)
        if (number.usual != 0) command.*number.value = number.usual;
    return command;
}

std::optional<CommandInfo> command_from(std::string_view name) {
    for (const CommandInfo& info : kCommands)
        if (info.name == name) return info;
    return std::nullopt;
}

std::string_view to_string(Layer layer) {
    return kLayers[static_cast<std::size_t>(layer)].second;
}
std::string_view to_string(Profile profile) {
    return kProfiles[static_cast<std::size_t>(profile)].second;
}
std::string_view to_string(Part part) {
    return kParts[static_cast<std::size_t>(part)].second;
}
std::optional<Layer> layer_from(std::string_view name) {
    return found<Layer>(kLayers, name);
}
std::optional<Profile> profile_from(std::string_view name) {
    return found<Profile>(kProfiles, name);
}
std::optional<Part> part_from(std::string_view name) {
    return found<Part>(kParts, name);
}

std::optional<std::size_t> param_from(std::string_view name) {
    for (std::size_t i = 0; i < std::size(kParams); ++i)
        if (kParams[i].name == name && !kParams[i].fixed) return i;
    return std::nullopt;
}

std::optional<std::string> fault_of(const Command& command, bool has_lower) {
    if (static_cast<std::size_t>(command.kind) >= std::size(kCommands))
        return "a command of kind " + std::to_string(static_cast<int>(command.kind)) + ", which there is not";
    const CommandInfo& info = info_of(command.kind);
    if (auto unused = fault_of_unused(command, info)) return unused;
    for (const CommandNumber& number : info.numbers) {
        const double value = command.*number.value;
        if (!(value >= number.least && value <= number.most))  // NaN too
            return std::string(info.name) + "'s " + std::string(number.name) + " is " +
                   number_text(value, number.unit) + ", outside " + number_text(number.least) + " to " +
                   number_text(number.most);
        if (number.whole && value != std::floor(value))
            return std::string(info.name) + "'s " + std::string(number.name) + " is " +
                   number_text(value, number.unit) + ", not a whole number";
    }
    if (command.kind == CommandKind::kStorm && command.precipitation > kMostStorm * command.hours)
        return "storm's precipitation is " + number_text(command.precipitation / command.hours, "mm") +
               " an hour, above " + number_text(kMostStorm);
    if (info.has_slope &&
        !(command.least_slope >= Command::kNoLeast && command.most_slope <= Command::kNoMost &&
          command.least_slope < command.most_slope))  // NaN too
        return std::string(info.name) + "'s slope is " + number_text(command.least_slope) + " to " +
               number_text(command.most_slope) + " degrees; 0 to 90, in ascending order, are allowed";
    if (command.of == Part::kLower && !has_lower)
        return std::string(info.name) + " is of the lower material, and this world has one material";
    if (info.has_param) {
        if (command.param >= std::size(kParams) || kParams[command.param].fixed)
            return "set is of parameter " + std::to_string(command.param) + ", which cannot be set";
        const ParamInfo& param = kParams[command.param];
        const auto value = static_cast<float>(command.value);  // what it will be
        if (!(value >= param.least && value <= param.most))
            return "set " + std::string(param.name) + " is " + number_text(command.value, param.unit) +
                   ", outside " + number_text(param.least) + " to " + number_text(param.most);
    }
    return std::nullopt;
}

void set_number(Params& params, const Command& set) {
    params.*kParams[set.param].value = static_cast<float>(set.value);
}

std::optional<std::string> fault_after(const Params& params, std::span<const Command> commands) {
    Params after = params;
    for (const Command& command : commands)
        if (command.kind == CommandKind::kSet) set_number(after, command);
    return after == params ? std::nullopt : fault_of(after);
}

std::optional<std::string> fault_of_counts(std::size_t given, std::size_t running) {
    if (given > kMostCommandsPerTick)
        return "over " + std::to_string(kMostCommandsPerTick) + " commands in one tick";
    if (running > kMostRunningCommands)
        return "over " + std::to_string(kMostRunningCommands) + " commands run at once";
    return std::nullopt;
}

std::int64_t ticks_of(const Command& command, float tick_s) {
    const bool lasts = command.kind == CommandKind::kPour || command.kind == CommandKind::kDig ||
                       command.kind == CommandKind::kWet || command.kind == CommandKind::kDrain;
    return lasts ? std::max<std::int64_t>(1, std::llrint(command.duration / static_cast<double>(tick_s))) : 1;
}

void apply_commands(State& state, std::span<const Command> commands) {
    for (const Command& command : commands) {
        CHECK(!fault_of_unused(command, info_of(command.kind)));
        state.running_commands.push_back({command, state.tick});
    }

    const double tick_s = state.params.tick_s;
    // What is known from objects and forest is found once after a row of commands, because it takes the whole grid.
    bool objects_changed = false, forest_changed = false;
    for (const RunningCommand& source : state.running_commands) {
        const Command& c = source.command;
        if (objects_changed && !is_of_objects(c)) {
            rebuild_objects(state);
            objects_changed = false;
        }
        const std::int64_t tick = state.tick - source.first_tick;
        switch (c.kind) {
            case CommandKind::kPour:
                pour(state, c, tick, ticks_of(c, state.params.tick_s), tick_s);
                break;
            case CommandKind::kDig:
                dig(state, c, tick, ticks_of(c, state.params.tick_s), tick_s);
                break;
            case CommandKind::kBlast:
                blast(state, c);
                break;
            case CommandKind::kSettle:
                settle(state, c);
                break;
            case CommandKind::kSculpt:
            case CommandKind::kSmooth:
            case CommandKind::kLevel:
                sculpt(state, c);
                break;
            case CommandKind::kPlant:
            case CommandKind::kFell:
                plant(state, c);
                forest_changed = true;
                break;
            case CommandKind::kHouse:
            case CommandKind::kLift:
            case CommandKind::kNet:
            case CommandKind::kRoad:
                build(state, c);
                objects_changed = true;
                break;
            case CommandKind::kTurn:
            case CommandKind::kRemove:
                rearrange(state, c);
                objects_changed = true;
                break;
            case CommandKind::kWet:
            case CommandKind::kDrain:
                soak(state, c, tick, ticks_of(c, state.params.tick_s), tick_s);
                break;
            case CommandKind::kStorm:
            case CommandKind::kWind:
            case CommandKind::kTemperature:
            case CommandKind::kCancel:
                CHECK(state.weather);
                change_program(*state.weather, c);
                break;
            case CommandKind::kSet:
                set_number(state.params, c);
                if (state.mixture) take_choices(state.params, state.mixture->lower);
                state.tiles.wake_all();  // ground that held with the old value may start with the new one
                break;
        }
    }
    if (objects_changed) rebuild_objects(state);
    if (forest_changed) rebuild_wooded(*state.things);
    std::erase_if(state.running_commands, [&](const RunningCommand& source) {
        return state.tick + 1 - source.first_tick >= ticks_of(source.command, state.params.tick_s);
    });
}

}  // namespace sim
