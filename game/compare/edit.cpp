#include "game/compare/edit.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "game/base/number.h"
#include "game/recording/scenario_difference.h"

namespace game {
namespace {

using Commands = std::vector<TimedCommand>;

std::string_view name_of(const TimedCommand& timed) {
    return sim::info_of(timed.command.kind).name;
}

std::string ticks_with_commands(const Commands& commands) {
    constexpr std::size_t kMost = 8;
    std::set<std::int64_t> ticks;
    for (const TimedCommand& each : commands) ticks.insert(each.tick);
    std::vector<std::int64_t> first(ticks.begin(), ticks.end());
    if (first.empty()) return "it has no commands";
    const bool more = first.size() > kMost;
    if (more) first.resize(kMost);
    return fmt::format("ticks with commands: {}{}", fmt::join(first, ", "), more ? ", …" : "");
}

// Index of the selected command.
Outcome<std::size_t> find(const Commands& commands, const Edit& edit) {
    std::vector<std::size_t> there;
    for (std::size_t i = 0; i < commands.size(); ++i)
        if (commands[i].tick == edit.tick) there.push_back(i);
    if (there.empty())
        return unusable(fmt::format("no command in tick {}; {}", edit.tick, ticks_with_commands(commands)));
    if (!edit.which && there.size() > 1) {
        std::vector<std::string> names;
        for (std::size_t i = 0; i < there.size(); ++i)
            names.push_back(fmt::format("{} {}", i + 1, to_text(commands[there[i]].command)));
        return unusable(fmt::format("{} commands in tick {}; choose one with --command: {}", there.size(),
                                    edit.tick, fmt::join(names, "; ")));
    }
    const int which = edit.which.value_or(1);
    if (which < 1 || static_cast<std::size_t>(which) > there.size())
        return unusable(fmt::format("--command {}: {} command{} in tick {}", which, there.size(),
                                    there.size() == 1 ? "" : "s", edit.tick));
    return there[static_cast<std::size_t>(which) - 1];
}

std::vector<std::string> members_of(const sim::CommandInfo& info) {
    std::vector<std::string> names;
    for (const sim::CommandNumber& number : info.numbers) names.emplace_back(number.name);
    if (info.has_param) names.emplace_back("param");
    if (info.has_layer) names.emplace_back("as");
    if (info.has_profile) names.emplace_back("profile");
    if (info.has_part) names.emplace_back("of");
    if (info.has_slope) names.emplace_back("slope");
    return names;
}

template <class Value>
Outcome<void> take(const std::string& name, const std::string& text, const std::optional<Value>& value,
                   Value& into) {
    if (!value) return unusable(fmt::format("--set {}: '{}' is not a valid value", name, text));
    into = *value;
    return {};
}

// Takes "30:45", the least and the most slope in degrees.
Outcome<void> take_slope(const std::string& text, sim::Command& command) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const Range<double> range{sim::Command::kNoLeast, sim::Command::kNoMost, "deg"};
    const auto least = number_from(text.substr(0, colon), range);
    const auto most = number_from(text.substr(std::min(colon + 1, text.size())), range);
    if (!least || !most || !(*least < *most))
        return unusable(
            fmt::format("--set slope: '{}' is not LEAST:MOST, two rising angles of 0 to 90", text));
    command.least_slope = *least, command.most_slope = *most;
    return {};
}

Outcome<void> set_member(sim::Command& command, const std::string& name, const std::string& text) {
    const sim::CommandInfo& info = sim::info_of(command.kind);
    for (const sim::CommandNumber& number : info.numbers) {
        if (name != number.name) continue;
        const auto value = number_from(text, Range<double>{number.least, number.most, number.unit});
        if (!value) return unusable(fmt::format("--set {}: {}", name, value.error()));
        command.*number.value = *value;
        return {};
    }
    if (info.has_param && name == "param") return take(name, text, sim::param_from(text), command.param);
    if (info.has_layer && name == "as") return take(name, text, sim::layer_from(text), command.layer);
    if (info.has_profile && name == "profile")
        return take(name, text, sim::profile_from(text), command.profile);
    if (info.has_part && name == "of") return take(name, text, sim::part_from(text), command.of);
    if (info.has_slope && name == "slope") return take_slope(text, command);
    return unusable(fmt::format("--set {}: unknown member of a {}; known are {}", name, info.name,
                                fmt::join(members_of(info), ", ")));
}

Outcome<void> set_members(sim::Command& command, const std::string& members) {
    for (std::size_t from = 0; from <= members.size();) {
        const std::size_t to = std::min(members.find(',', from), members.size());
        const std::string member = members.substr(from, to - from);
        const std::size_t equals = member.find('=');
        if (equals == std::string::npos)
            return unusable(fmt::format("--set {}: '{}' is not NAME=VALUE; numbers have a decimal point",
                                        members, member));
        if (auto set = set_member(command, member.substr(0, equals), member.substr(equals + 1)); !set)
            return set;
        from = to + 1;
    }
    return {};
}

bool has_place(const sim::Command& command) {
    return command.kind != sim::CommandKind::kSet;
}

// Whether it leads from one place to another.
bool is_line(const sim::Command& command) {
    return std::ranges::any_of(sim::info_of(command.kind).numbers, [](const sim::CommandNumber& number) {
        return number.value == &sim::Command::to_x;
    });
}

// The changed command; nothing if it is deleted.
struct Change {
    float tick_s;
    std::int64_t last_tick;  // of the recording
    TimedCommand command;

    using Result = Outcome<std::optional<TimedCommand>>;
    Result operator()(const Edit::Delete&) const { return std::nullopt; }
    Result operator()(const Edit::Set& set) const {
        TimedCommand changed = command;
        if (auto done = set_members(changed.command, set.members); !done) return tl::unexpected(done.error());
        return changed;
    }
    Result operator()(const Edit::Move& move) const {
        if (!has_place(command.command)) return unusable("--move: a 'set' command has no position");
        TimedCommand changed = command;
        changed.command.x += move.by.x, changed.command.y += move.by.y;
        if (is_line(command.command)) changed.command.to_x += move.by.x, changed.command.to_y += move.by.y;
        return changed;
    }
    Result operator()(const Edit::Delay& delay) const {
        TimedCommand changed = command;
        const double tick =
            static_cast<double>(command.tick) + std::round(delay.seconds / static_cast<double>(tick_s));
        const std::int64_t latest = last_tick + kMostTicksAfterEnd;
        if (!(tick >= 0))
            return unusable(fmt::format("--delay {}: the {} would come before the first tick", delay.seconds,
                                        name_of(command)));
        if (!(tick <= static_cast<double>(latest)))
            return unusable(
                fmt::format("--delay {}: the {} would come after tick {}, more than {} ticks after the end "
                            "of the recording",
                            delay.seconds, name_of(command), latest, kMostTicksAfterEnd));
        changed.tick = static_cast<std::int64_t>(tick);
        return changed;
    }
};

}  // namespace

Outcome<Edited> edited(const Recording& recording, const Edit& edit) {
    Edited result{recording.commands, {}};
    const auto place = find(result.commands, edit);
    if (!place) return tl::unexpected(place.error());
    const auto at = result.commands.begin() + static_cast<std::ptrdiff_t>(*place);
    const TimedCommand before = *at;
    const Scenario& scenario = recording.header.scenario;
    const auto after = std::visit(Change{scenario.params.tick_s, recording.last_tick(), before}, edit.change);
    if (!after) return tl::unexpected(after.error());

    result.change = fmt::format("tick {}: {}", before.tick, to_text(before.command));
    result.commands.erase(at);
    if (*after) {
        if (const auto fault = sim::fault_of((*after)->command, scenario.lower.has_value()))
            return unusable(*fault);
        const auto later = [](std::int64_t tick, const TimedCommand& than) { return tick < than.tick; };
        // At its old place if it stays in its tick, else after the commands already there.
        const auto into =
            (*after)->tick == before.tick
                ? result.commands.begin() + static_cast<std::ptrdiff_t>(*place)
                : std::upper_bound(result.commands.begin(), result.commands.end(), (*after)->tick, later);
        result.commands.insert(into, **after);
        result.change += fmt::format(" becomes tick {}: {}", (*after)->tick, to_text((*after)->command));
    } else {
        result.change += " is deleted";
    }
    if (const auto fault = fault_of_commands(scenario.params, result.commands)) return unusable(*fault);
    return result;
}

}  // namespace game
