#include "game/recording/goal_json.h"

#include <algorithm>
#include <string>

#include "game/recording/command_json.h"
#include "sim/world/command.h"

namespace game::values {
namespace {

constexpr std::size_t kMostEvents = 1'000'000;

Json area_json(const Area& area) {
    return {{area.shape == Area::Shape::kBox ? "box" : "ellipse",
             numbers({area.from.x, area.from.y, area.to.x, area.to.y})}};
}

Area area_from(const Json& json) {
    const bool is_box = json.is_object() && json.contains("box");
    const Json& numbers = list(json, is_box ? "box" : "ellipse", 4);
    if (numbers.size() != 4) refuse("an area of the goal is not four numbers");
    const auto number_at = [&](std::size_t i) {
        if (!numbers.at(i).is_number()) refuse("an area of the goal is not four numbers");
        return numbers.at(i).get<double>();
    };
    return {is_box ? Area::Shape::kBox : Area::Shape::kEllipse,
            {number_at(0), number_at(1)},
            {number_at(2), number_at(3)}};
}

sim::CommandKind kind_from(const Json& json, const char* key) {
    return named(json, key, sim::command_from).kind;
}

Json tool_json(const Goal::Tool& tool) {
    Json json{{"command", sim::info_of(tool.kind).name}};
    if (tool.count) json["count"] = *tool.count;
    if (tool.total) json["total"] = *tool.total;
    for (const Goal::Limit& limit : tool.limits)
        json["limits"][limit.number] = numbers({limit.least, limit.most});
    if (tool.layer) json["as"] = sim::to_string(*tool.layer);
    return json;
}

Goal::Tool tool_from(const Json& json) {
    Goal::Tool tool;
    tool.kind = kind_from(json, "command");
    if (json.contains("count")) tool.count = whole(json, "count", 1, Goal::kMostCount);
    if (json.contains("total")) tool.total = number(json, "total", 0, Goal::kGreatest);
    if (json.contains("as")) tool.layer = named(json, "as", sim::layer_from);
    if (!json.contains("limits")) return tool;
    const Json& limits = member(json, "limits");
    if (!limits.is_object()) refuse("limits of a tool is not an object");
    const auto& known = sim::info_of(tool.kind).numbers;
    for (const auto& [name, value] : limits.items()) {
        if (std::ranges::find(known, name, &sim::CommandNumber::name) == known.end())
            refuse(fmt::format("{} has no {}", sim::info_of(tool.kind).name, name));
        if (!value.is_array() || value.size() != 2 || !value.at(0).is_number() || !value.at(1).is_number())
            refuse(fmt::format("the limits of {} are not two numbers", name));
        tool.limits.push_back({name, value.at(0).get<double>(), value.at(1).get<double>()});
    }
    return tool;
}

Json quantity_json(const Quantity& quantity) {
    const MeasureInfo& info = info_of(quantity.measure);
    Json json{{"measure", info.name}};
    if (quantity.area) json["area"] = area_json(*quantity.area);
    if (info.has_tool) json["of"] = sim::info_of(quantity.tool).name;
    return json;
}

Quantity quantity_from(const Json& json) {
    Quantity quantity;
    quantity.measure = named(json, "measure", measure_from);
    if (json.contains("area")) quantity.area = area_from(member(json, "area"));
    if (info_of(quantity.measure).has_tool) quantity.tool = kind_from(json, "of");
    return quantity;
}

Json event_json(const TimedCommand& event) {
    std::string text(1, '{');
    write(event.command, text);
    text += '}';
    Json json = Json::parse(text);
    json["tick"] = event.tick;
    return json;
}

TimedCommand event_from(const Json& json) {
    const sim::CommandInfo* const info = json.is_object() ? kind_in(json) : nullptr;
    if (!info) refuse("an event of the goal is of unknown kind");
    return {whole(json, "tick", 0, std::int64_t{1} << 40), command_from(json, *info)};
}

}  // namespace

Json goal_json(const Goal& goal) {
    Json json{{"say", goal.say}};
    if (!goal.learn.empty()) json["learn"] = goal.learn;
    if (goal.zone) json["zone"] = area_json(*goal.zone);
    for (const Goal::Tool& tool : goal.tools) json["tools"].push_back(tool_json(tool));
    for (const Goal::Need& need : goal.needs) {
        Json each = quantity_json(need.quantity);
        each[need.least ? "least" : "most"] = need.least ? *need.least : *need.most;
        json["needs"].push_back(std::move(each));
    }
    json["base"] = goal.base;
    for (const Goal::Term& term : goal.score) {
        Json each = quantity_json(term.quantity);
        each["times"] = term.times;
        json["score"].push_back(std::move(each));
    }
    if (goal.combine != Goal::Combine::kSum) json["combine"] = to_string(goal.combine);
    json["medals"] = goal.medals;
    json["earliest_s"] = goal.earliest_s;
    if (goal.latest_s) json["latest_s"] = *goal.latest_s;
    for (const TimedCommand& event : goal.events) json["events"].push_back(event_json(event));
    return json;
}

Goal goal_from(const Json& json) {
    Goal goal;
    goal.say = text(json, "say");
    if (json.contains("learn")) goal.learn = text(json, "learn");
    if (json.contains("zone")) goal.zone = area_from(member(json, "zone"));
    for (const Json& each : list(json, "tools", Goal::kMostTools)) goal.tools.push_back(tool_from(each));
    for (const Json& each : list(json, "needs", Goal::kMostNeeds)) {
        Goal::Need need{quantity_from(each), std::nullopt, std::nullopt};
        if (each.contains("least")) need.least = number(each, "least", -Goal::kGreatest, Goal::kGreatest);
        if (each.contains("most")) need.most = number(each, "most", -Goal::kGreatest, Goal::kGreatest);
        goal.needs.push_back(need);
    }
    goal.base = number(json, "base", -Goal::kGreatest, Goal::kGreatest);
    for (const Json& each : list(json, "score", Goal::kMostTerms))
        goal.score.push_back({quantity_from(each), number(each, "times", -Goal::kGreatest, Goal::kGreatest)});
    if (json.contains("combine")) goal.combine = named(json, "combine", combine_from);
    const Json& medals = list(json, "medals", goal.medals.size());
    if (medals.size() != goal.medals.size()) refuse("medals is not three whole numbers");
    for (std::size_t i = 0; i < goal.medals.size(); ++i) {
        if (!medals.at(i).is_number_integer()) refuse("medals is not three whole numbers");
        goal.medals.at(i) = medals.at(i).get<std::int64_t>();
    }
    goal.earliest_s = number(json, "earliest_s", 0, Goal::kLongest);
    if (json.contains("latest_s")) goal.latest_s = number(json, "latest_s", 0, Goal::kLongest);
    for (const Json& each : list(json, "events", kMostEvents)) goal.events.push_back(event_from(each));
    if (!std::ranges::is_sorted(goal.events, {}, &TimedCommand::tick))
        refuse("the events of the goal are not in the order of their ticks");
    if (const auto wrong = fault_of(goal)) refuse("the goal " + *wrong);
    return goal;
}

}  // namespace game::values
