#include "game/scene/scene_commands.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace game {

sim::Command read_command(TomlTable& table, const sim::CommandInfo& info, bool has_lower) {
    sim::Command command;
    command.kind = info.kind;
    for (const sim::CommandNumber& number : info.numbers) {
        const auto value = table.number(number.name, number.least, number.most);
        if (!value) table.blame("", fmt::format("needs {} in {}", number.name, number.unit));
        command.*number.value = value.value_or(0);
    }
    if (info.has_param) {
        const auto param = sim::param_from(table.text("param").value_or(""));
        if (!param) table.blame("param", "is not a parameter that can be set");
        command.param = param.value_or(0);
        if (const auto wrong = sim::fault_of(command); wrong && param) table.blame("value", *wrong);
    }
    if (info.has_layer)
        if (const auto name = table.text("as")) {
            const auto layer = sim::layer_from(*name);
            if (!layer) table.blame("as", "is neither rolling nor standing");
            command.layer = layer.value_or(command.layer);
        }
    if (info.has_profile)
        if (const auto name = table.text("profile")) {
            const auto profile = sim::profile_from(*name);
            if (!profile) table.blame("profile", "is neither disc nor cone");
            command.profile = profile.value_or(command.profile);
        }
    if (info.has_part)
        if (const auto name = table.text("of")) {
            const auto part = sim::part_from(*name);
            if (!part) table.blame("of", "is neither upper nor lower");
            if (part == sim::Part::kLower && !has_lower)
                table.blame("of", "is lower, and the scene has no [under]");
            command.of = part.value_or(command.of);
        }
    if (info.has_slope)
        if (const auto slope = table.numbers("slope", 2)) {
            command.least_slope = (*slope)[0], command.most_slope = (*slope)[1];
            const bool rises = sim::Command::kNoLeast <= command.least_slope &&
                               command.least_slope < command.most_slope &&
                               command.most_slope <= sim::Command::kNoMost;
            if (!rises) table.blame("slope", "is not two rising angles of 0 to 90 degrees");
        }
    table.finish();
    return command;
}

namespace {

std::string command_names() {
    std::string names;
    for (const sim::CommandInfo& info : sim::kCommands)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", info.name);
    return names;
}

}  // namespace

std::vector<TimedCommand> read_commands(TomlTable& root, double tick_s, bool has_lower) {
    std::vector<TimedCommand> commands;
    for (TomlTable& table : root.tables("command")) {
        const auto at = table.number("at", 0, 1e5);
        if (!at) table.blame("", "needs `at`, in seconds");
        int given = 0;
        for (const sim::CommandInfo& info : sim::kCommands)
            if (auto numbers = table.table(info.name)) {
                commands.push_back(
                    {std::llrint(at.value_or(0) / tick_s), read_command(*numbers, info, has_lower)});
                ++given;
            }
        table.finish();
        if (given != 1) table.blame("", fmt::format("needs exactly one of {}", command_names()));
    }
    std::stable_sort(commands.begin(), commands.end(),
                     [](const TimedCommand& a, const TimedCommand& b) { return a.tick < b.tick; });
    return commands;
}

}  // namespace game
