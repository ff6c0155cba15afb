#include "game/recording/scenario_difference.h"

#include <algorithm>

#include <fmt/format.h>

#include "sim/world/params.h"

namespace game {
namespace {

template <class A, class B>
std::string differs(std::string_view what, const A& a, const B& b) {
    return fmt::format("{} is {} in the first and {} in the second", what, a, b);
}

void add_choices(const sim::Params& a, const sim::Params& b, std::vector<std::string>& found) {
    const auto add = [&](std::string_view what, auto one, auto other) {
        if (one != other) found.push_back(differs(what, sim::to_string(one), sim::to_string(other)));
    };
    add("the model", a.model, b.model);
    add("the scheme", a.scheme, b.scheme);
    add("the law", a.law, b.law);
    for (std::size_t side = 0; side < a.borders.size(); ++side)
        add(fmt::format("the {} border", sim::kSides[side]), a.borders[side], b.borders[side]);
}

void add_numbers(const std::string& of, const sim::Params& a, const sim::Params& b,
                 std::vector<std::string>& found) {
    for (const sim::ParamInfo& info : sim::kParams)
        if (a.*info.value != b.*info.value)
            found.push_back(differs(fmt::format("{}{}", of, info.name), a.*info.value, b.*info.value));
}

// A field that is empty is 0 everywhere.
void add_field(const char* what, const std::vector<float>& a, const std::vector<float>& b,
               std::vector<std::string>& found) {
    std::size_t count = 0;
    const auto at = [](const std::vector<float>& field, std::size_t i) {
        return i < field.size() ? field[i] : 0.f;
    };
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) count += at(a, i) != at(b, i);
    if (count > 0) found.push_back(fmt::format("{} differs at {} vertices", what, count));
}

struct Choice {
    std::string_view name;
    std::string value;
};
// The members of a command that are not numbers.
std::vector<Choice> choices_of(const sim::Command& command) {
    const sim::CommandInfo& info = sim::info_of(command.kind);
    std::vector<Choice> choices;
    if (info.has_param) choices.push_back({"param", std::string(sim::kParams[command.param].name)});
    if (info.has_layer) choices.push_back({"as", std::string(sim::to_string(command.layer))});
    if (info.has_profile) choices.push_back({"profile", std::string(sim::to_string(command.profile))});
    if (info.has_part) choices.push_back({"of", std::string(sim::to_string(command.of))});
    if (info.has_slope)
        choices.push_back({"slope", fmt::format("{}:{}", command.least_slope, command.most_slope)});
    return choices;
}

bool is_usual(const Choice& choice, const sim::Command& command) {
    if (choice.name == "of") return command.of == sim::Part::kUpper;
    return choice.name == "slope" && command.least_slope == sim::Command::kNoLeast &&
           command.most_slope == sim::Command::kNoMost;
}

void add_members(const TimedCommand& a, const TimedCommand& b, std::vector<std::string>& found) {
    const sim::CommandInfo& info = sim::info_of(a.command.kind);
    if (a.tick != b.tick)
        found.push_back(differs(fmt::format("the tick of a {}", info.name), a.tick, b.tick));
    const auto what = [&](std::string_view member) {
        return fmt::format("at tick {} the {}'s {}", a.tick, info.name, member);
    };
    for (const sim::CommandNumber& number : info.numbers)
        if (a.command.*number.value != b.command.*number.value)
            found.push_back(differs(what(number.name), a.command.*number.value, b.command.*number.value));
    const auto choices = choices_of(a.command), others = choices_of(b.command);
    for (std::size_t i = 0; i < choices.size(); ++i)
        if (choices[i].value != others[i].value)
            found.push_back(differs(what(choices[i].name), choices[i].value, others[i].value));
}

}  // namespace

std::vector<std::string> differences_of_ground(const Scenario& a, const Scenario& b) {
    std::vector<std::string> found;
    if (a.grid != b.grid) {
        const auto text = [](const sim::Grid& grid) {
            return fmt::format("{}x{} squares of {:.4g} m", grid.nx - 1, grid.ny - 1, grid.dx);
        };
        found.push_back(differs("the grid", text(a.grid), text(b.grid)));
        return found;
    }
    const std::size_t before = found.size();
    if (a.datum != b.datum) found.push_back(differs("the datum", a.datum, b.datum));
    add_field("bedrock", a.bedrock, b.bedrock, found);
    if (a.has_data != b.has_data) found.emplace_back("the areas without data differ");
    if (found.size() > before && a.terrain != b.terrain)
        found.insert(found.begin(), differs("the terrain", a.terrain, b.terrain));
    return found;
}

void add_density(const std::string& what, std::optional<double> a, std::optional<double> b,
                 std::vector<std::string>& found) {
    const auto text = [](std::optional<double> density) {
        return density ? fmt::format("{:g} kg/m3", *density) : "unknown";
    };
    if (a != b) found.push_back(differs(what, text(a), text(b)));
}

void add_standing(const Scenario::Standing& a, const Scenario::Standing& b, std::vector<std::string>& found) {
    const sim::Stems none;
    std::size_t stems = 0;
    for (std::size_t i = 0; i < std::max(a.forest.size(), b.forest.size()); ++i)
        stems += (i < a.forest.size() ? a.forest[i] : none) != (i < b.forest.size() ? b.forest[i] : none);
    if (stems > 0) found.push_back(fmt::format("the forest differs at {} vertices", stems));
    const auto budget = [](double m3) { return m3 < 0 ? "without limit" : fmt::format("{} m3", m3); };
    if (a.earth_budget != b.earth_budget)
        found.push_back(differs("the budget of earth", budget(a.earth_budget), budget(b.earth_budget)));
    add_field("earth", a.earth, b.earth, found);
    add_field("the water", a.water, b.water, found);
    // As commands of one tick, of which the differences are known.
    const auto timed = [](const Scenario::Standing& standing) {
        std::vector<TimedCommand> commands;
        for (const sim::Command& each : standing.placed) commands.push_back({0, each});
        return commands;
    };
    for (const std::string& each : differences_of(timed(a), timed(b)))
        found.push_back(fmt::format("before the start, {}", each));
}

std::vector<std::string> differences_of(const Scenario& a, const Scenario& b) {
    std::vector<std::string> found = differences_of_ground(a, b);
    add_choices(a.params, b.params, found);
    add_numbers("", a.params, b.params, found);
    add_density("the density", a.density, b.density, found);
    if (a.lower.has_value() != b.lower.has_value())
        found.push_back(
            fmt::format("only the {} has a second material", a.lower.has_value() ? "first" : "second"));
    else if (a.lower) {
        add_numbers("the lower material's ", a.lower->params, b.lower->params, found);
        add_density("the lower material's density", a.lower->density, b.lower->density, found);
    }
    if (a.weather.has_value() != b.weather.has_value())
        found.push_back(fmt::format("only the {} has weather", a.weather.has_value() ? "first" : "second"));
    else if (a.weather)
        for (const sim::CalendarNumber& number : sim::kCalendarNumbers)
            if (const double one = (*a.weather).*number.value, other = (*b.weather).*number.value;
                one != other)
                found.push_back(differs(fmt::format("the weather's {}", number.name), one, other));
    if (a.grid != b.grid) return found;
    add_field("the cover's depth", a.depth, b.depth, found);
    add_field("the release", a.rolling, b.rolling, found);
    add_standing(a.standing, b.standing, found);
    if (!a.lower || !b.lower) return found;
    add_field("the lower material's depth", a.lower->depth, b.lower->depth, found);
    add_field("the lower material in deposits", a.lower->settled, b.lower->settled, found);
    add_field("the lower material in the release", a.lower->rolling, b.lower->rolling, found);
    return found;
}

std::vector<std::string> differences_of(std::span<const TimedCommand> a, std::span<const TimedCommand> b) {
    const auto same = [](const TimedCommand& one, const TimedCommand& other) {
        return one.tick == other.tick && one.command == other.command;
    };
    while (!a.empty() && !b.empty() && same(a.front(), b.front())) a = a.subspan(1), b = b.subspan(1);
    while (!a.empty() && !b.empty() && same(a.back(), b.back()))
        a = a.first(a.size() - 1), b = b.first(b.size() - 1);

    std::vector<std::string> found;
    const auto same_kinds = [&] {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
            return one.command.kind == other.command.kind;
        });
    };
    if (same_kinds()) {
        for (std::size_t i = 0; i < a.size(); ++i) add_members(a[i], b[i], found);
        return found;
    }
    const auto only = [&](const char* which, std::span<const TimedCommand> commands) {
        for (const TimedCommand& each : commands)
            found.push_back(
                fmt::format("only the {} has, at tick {}: {}", which, each.tick, to_text(each.command)));
    };
    only("first", a), only("second", b);
    return found;
}

std::string to_text(const sim::Command& command) {
    std::string text(sim::info_of(command.kind).name);
    for (const sim::CommandNumber& number : sim::info_of(command.kind).numbers)
        text += fmt::format(" {}={}", number.name, command.*number.value);
    for (const Choice& choice : choices_of(command))
        if (!is_usual(choice, command)) text += fmt::format(" {}={}", choice.name, choice.value);
    return text;
}

}  // namespace game
