#include "game/scene/scene_goal.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace game {
namespace {

std::string text_of_key(TomlTable& table, std::string_view key) {
    std::string text = table.text(key).value_or("");
    if (text.size() > Goal::kMostText)
        table.blame(key, fmt::format("has more than {} bytes", Goal::kMostText));
    return text;
}

std::optional<Area> read_area(TomlTable& table, std::string_view key) {
    auto inner = table.table(key);
    if (!inner) return std::nullopt;
    const auto box = inner->numbers("box", 4), ellipse = inner->numbers("ellipse", 4);
    inner->finish();
    if (box.has_value() == ellipse.has_value()) inner->blame("", "needs either a box or an ellipse");
    const auto& numbers = box ? box : ellipse;
    if (!numbers) return std::nullopt;
    const Area area{box ? Area::Shape::kBox : Area::Shape::kEllipse,
                    {(*numbers)[0], (*numbers)[1]},
                    {(*numbers)[2], (*numbers)[3]}};
    if (box && !(area.from.x < area.to.x && area.from.y < area.to.y))
        inner->blame("box", "is not west, south, east, north");
    if (ellipse && !(area.to.x > 0 && area.to.y > 0))
        inner->blame("ellipse", "has half axes that are not positive");
    return area;
}

std::optional<sim::CommandInfo> read_command_name(TomlTable& table, std::string_view key) {
    const auto name = table.text(key);
    const auto info = sim::command_from(name.value_or(""));
    if (!info) table.blame(key, "is not the name of a command");
    return info;
}

Goal::Tool read_tool(TomlTable& table) {
    Goal::Tool tool;
    const auto info = read_command_name(table, "command");
    if (!info) return tool;
    tool.kind = info->kind;
    tool.count = table.whole("count", 1, Goal::kMostCount);
    tool.total = table.number("total", 0, Goal::kGreatest);
    for (const sim::CommandNumber& number : info->numbers) {
        if (!table.has(number.name)) continue;
        if (!table.is_list(number.name)) {
            const double value = table.number(number.name, number.least, number.most).value_or(0);
            tool.limits.push_back({std::string(number.name), value, value});
        } else if (const auto range = table.numbers(number.name, 2)) {
            const double least = (*range)[0], most = (*range)[1];
            if (!(number.least <= least && least <= most && most <= number.most))
                table.blame(number.name,
                            fmt::format("is not two rising numbers of {} to {}", number.least, number.most));
            tool.limits.push_back({std::string(number.name), least, most});
        }
    }
    if (info->has_layer)
        if (const auto name = table.text("as")) {
            tool.layer = sim::layer_from(*name);
            if (!tool.layer) table.blame("as", "is neither rolling nor standing");
        }
    table.finish();
    return tool;
}

Quantity read_quantity(TomlTable& table) {
    Quantity quantity;
    const auto measure = measure_from(table.text("measure").value_or(""));
    if (!measure) {
        std::string names;
        for (const MeasureInfo& info : measure_infos())
            names += fmt::format("{}{}", names.empty() ? "" : ", ", info.name);
        table.blame("measure", fmt::format("is not one of {}", names));
        return quantity;
    }
    quantity.measure = *measure;
    const MeasureInfo& info = info_of(*measure);
    if (info.has_area) quantity.area = read_area(table, "area");
    if (info.has_tool)
        if (const auto tool = read_command_name(table, "of")) quantity.tool = tool->kind;
    return quantity;
}

Goal::Need read_need(TomlTable& table) {
    Goal::Need need{read_quantity(table), table.number("least", -Goal::kGreatest, Goal::kGreatest),
                    table.number("most", -Goal::kGreatest, Goal::kGreatest)};
    table.finish();
    return need;
}

Goal::Term read_term(TomlTable& table) {
    Goal::Term term{read_quantity(table),
                    table.number("times", -Goal::kGreatest, Goal::kGreatest).value_or(1)};
    table.finish();
    return term;
}

// Reads an array of tables, at most so many.
template <class Read>
auto read_all(TomlTable& table, std::string_view key, std::size_t most, Read&& read) {
    std::vector<decltype(read(table))> all;
    std::vector<TomlTable> tables = table.tables(key);
    if (tables.size() > most) table.blame(key, fmt::format("has more than {}", most));
    all.reserve(tables.size());
    for (TomlTable& each : tables) all.push_back(read(each));
    return all;
}

}  // namespace

Goal read_goal(TomlTable& table) {
    Goal goal;
    goal.say = text_of_key(table, "say");
    goal.learn = text_of_key(table, "learn");
    goal.zone = read_area(table, "zone");
    goal.tools = read_all(table, "tool", Goal::kMostTools, read_tool);
    goal.needs = read_all(table, "need", Goal::kMostNeeds, read_need);
    goal.score = read_all(table, "score", Goal::kMostTerms, read_term);
    goal.base = table.number("base", -Goal::kGreatest, Goal::kGreatest).value_or(0);
    if (const auto name = table.text("combine")) {
        const auto combine = combine_from(*name);
        if (!combine) table.blame("combine", "is neither sum nor smallest");
        goal.combine = combine.value_or(goal.combine);
    }
    goal.earliest_s = table.number("earliest", 0, Goal::kLongest).value_or(0);
    goal.latest_s = table.number("latest", 0, Goal::kLongest);
    if (const auto medals = table.numbers("medals", 3))
        std::ranges::transform(*medals, goal.medals.begin(), [](double score) { return std::llrint(score); });
    else if (!table.has("medals"))
        table.blame("", "needs medals: least scores for bronze, silver and gold");
    table.finish();
    if (const auto wrong = fault_of(goal)) table.blame("", *wrong);
    return goal;
}

}  // namespace game
