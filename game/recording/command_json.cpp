#include "game/recording/command_json.h"

#include <iterator>

#include <fmt/format.h>

#include "sim/world/params.h"

namespace game::values {
namespace {

// Appends the shortest text that reads back as the same double, and as a double: "-0" would lose its sign.
void append(double value, std::string& line) {
    const std::size_t before = line.size();
    fmt::format_to(std::back_inserter(line), "{}", value);
    if (line.find_first_of(".e", before) == std::string::npos) line += ".0";
}

bool filters_slope(const sim::Command& command) {
    return command.least_slope != sim::Command::kNoLeast || command.most_slope != sim::Command::kNoMost;
}

}  // namespace

void write(const sim::Command& command, std::string& line) {
    const sim::CommandInfo& info = sim::info_of(command.kind);
    const auto out = std::back_inserter(line);
    fmt::format_to(out, R"("{}":{{)", info.name);
    if (info.has_param) fmt::format_to(out, R"("param":"{}",)", sim::kParams[command.param].name);
    for (const sim::CommandNumber& each : info.numbers) {
        fmt::format_to(out, R"("{}":)", each.name);
        append(command.*each.value, line);
        line += ',';
    }
    if (info.has_layer) fmt::format_to(out, R"("as":"{}",)", sim::to_string(command.layer));
    if (info.has_profile) fmt::format_to(out, R"("profile":"{}",)", sim::to_string(command.profile));
    if (command.of != sim::Part::kUpper) fmt::format_to(out, R"("of":"{}",)", sim::to_string(command.of));
    if (filters_slope(command)) {
        line += R"("slope":[)";
        append(command.least_slope, line);
        line += ',';
        append(command.most_slope, line);
        line += "],";
    }
    line.back() = '}';  // the last comma
}

const sim::CommandInfo* kind_in(const Json& json) {
    for (const sim::CommandInfo& info : sim::kCommands)
        if (json.contains(info.name)) return &info;
    return nullptr;
}

sim::Command command_from(const Json& json, const sim::CommandInfo& info) {
    const Json& members = member(json, info.name.data());
    sim::Command command;
    command.kind = info.kind;
    for (const sim::CommandNumber& each : info.numbers)
        command.*each.value = number(members, each.name.data(), each.least, each.most);
    if (info.has_param) command.param = named(members, "param", sim::param_from);
    if (info.has_layer) command.layer = named(members, "as", sim::layer_from);
    if (info.has_profile) command.profile = named(members, "profile", sim::profile_from);
    if (info.has_part && members.contains("of")) command.of = named(members, "of", sim::part_from);
    if (info.has_slope && members.contains("slope")) {
        const glm::dvec2 slope = range(members, "slope", sim::Command::kNoLeast, sim::Command::kNoMost);
        command.least_slope = slope.x, command.most_slope = slope.y;
    }
    if (const auto wrong = sim::fault_of(command)) refuse(*wrong);
    return command;
}

}  // namespace game::values
