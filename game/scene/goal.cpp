#include "game/scene/goal.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

#include "sim/core/number_text.h"

namespace game {
namespace {

constexpr MeasureInfo kMeasures[] = {
    {Measure::kRunOut, "run_out", "m", "run-out", false, false},
    {Measure::kDrop, "drop", "m", "drop", false, false},
    {Measure::kTopSpeed, "top_speed", "m/s", "top speed", false, false},
    {Measure::kEroded, "eroded", "m3", "swept along", false, false},
    {Measure::kDeposit, "deposit", "m3", "deposit", true, false},
    {Measure::kRemoved, "removed", "%", "emptied", true, false},
    {Measure::kLoad, "load", "kPa", "greatest load on a house", false, false},
    {Measure::kDestroyed, "destroyed", "houses", "destroyed", false, false},
    {Measure::kBlocked, "blocked", "m", "blocked road", false, false},
    {Measure::kBroken, "broken", "ha", "broken forest", false, false},
    {Measure::kUnused, "unused", "", "unused", false, true},
    {Measure::kTime, "time", "s", "time", false, false},
    {Measure::kEarth, "earth", "m3", "earth in use", false, false},
};

double disc_area(const sim::Command& command) {
    return std::numbers::pi * command.radius * command.radius;
}

// Sums of shares of a budget may exceed it by the rounding of a tick's length.
constexpr double kRounding = 1e-6;

}  // namespace

bool Area::has(double x, double y) const {
    if (shape == Shape::kBox) return from.x <= x && x <= to.x && from.y <= y && y <= to.y;
    const double east = (x - from.x) / to.x, north = (y - from.y) / to.y;
    return east * east + north * north <= 1;
}

std::span<const MeasureInfo> measure_infos() {
    return kMeasures;
}

const MeasureInfo& info_of(Measure measure) {
    return kMeasures[static_cast<std::size_t>(measure)];
}

std::optional<Measure> measure_from(std::string_view name) {
    const auto found = std::ranges::find(kMeasures, name, &MeasureInfo::name);
    if (found == std::end(kMeasures)) return std::nullopt;
    return found->measure;
}

std::string_view to_string(Goal::Combine combine) {
    return combine == Goal::Combine::kSmallest ? "smallest" : "sum";
}

std::optional<Goal::Combine> combine_from(std::string_view name) {
    for (const auto combine : {Goal::Combine::kSum, Goal::Combine::kSmallest})
        if (to_string(combine) == name) return combine;
    return std::nullopt;
}

std::string_view unit_of(sim::CommandKind kind) {
    switch (kind) {
        case sim::CommandKind::kPour:
        case sim::CommandKind::kDig:
        case sim::CommandKind::kWet:
        case sim::CommandKind::kDrain:
            return "m3";
        case sim::CommandKind::kPlant:
            return "ha";
        case sim::CommandKind::kNet:
        case sim::CommandKind::kRoad:
            return "m";
        default:
            return "";
    }
}

double cost_of(const sim::Command& command, float tick_s) {
    constexpr double kHectare = 1e4;  // m²
    const double seconds = static_cast<double>(sim::ticks_of(command, tick_s)) * static_cast<double>(tick_s);
    switch (command.kind) {
        case sim::CommandKind::kPour:
            return command.rate * seconds;
        case sim::CommandKind::kDig:
            return command.rate * seconds * disc_area(command);
        case sim::CommandKind::kWet:
        case sim::CommandKind::kDrain: {
            const double mean = command.profile == sim::Profile::kCone ? 1. / 3 : 1;
            return command.rate * seconds * mean * disc_area(command);
        }
        case sim::CommandKind::kPlant:
            return disc_area(command) / kHectare;
        case sim::CommandKind::kNet:
        case sim::CommandKind::kRoad: {
            const double x = command.to_x - command.x, y = command.to_y - command.y;
            return std::sqrt(x * x + y * y);
        }
        default:
            return 0;
    }
}

std::optional<std::string> fault_of(const Goal& goal) {
    if (goal.say.empty()) return "says nothing";
    if (goal.score.empty()) return "has no score";
    if (!std::ranges::is_sorted(goal.medals)) return "has medals that do not rise";
    if (goal.latest_s && *goal.latest_s <= goal.earliest_s) return "ends before it may end";
    for (std::size_t i = 0; i < goal.tools.size(); ++i) {
        const Goal::Tool& tool = goal.tools[i];
        const std::string_view name = sim::info_of(tool.kind).name;
        for (std::size_t k = 0; k < i; ++k)
            if (goal.tools[k].kind == tool.kind) return fmt::format("has the tool {} twice", name);
        if (tool.total && unit_of(tool.kind).empty())
            return fmt::format("has a total of {}, which only a count can limit", name);
    }
    const auto fault_of_quantity = [&](const Quantity& quantity) -> std::optional<std::string> {
        const MeasureInfo& info = info_of(quantity.measure);
        if (quantity.area && !info.has_area) return fmt::format("measures {} in an area", info.name);
        if (!info.has_tool) return std::nullopt;
        const Goal::Tool* const tool = tool_of(goal, quantity.tool);
        if (!tool)
            return fmt::format("counts what is unused of {}, which is no tool of it",
                               sim::info_of(quantity.tool).name);
        if (!tool->total && !tool->count)
            return fmt::format("counts what is unused of {}, of which there is no end",
                               sim::info_of(quantity.tool).name);
        return std::nullopt;
    };
    for (const Goal::Need& need : goal.needs) {
        if (need.least.has_value() == need.most.has_value())
            return fmt::format("needs a {} that has not one of `least` and `most`",
                               info_of(need.quantity.measure).name);
        if (auto wrong = fault_of_quantity(need.quantity)) return wrong;
    }
    for (const Goal::Term& term : goal.score)
        if (auto wrong = fault_of_quantity(term.quantity)) return wrong;
    return std::nullopt;
}

const Goal::Limit* limit_of(const Goal::Tool& tool, double sim::Command::*number) {
    const auto numbers = sim::info_of(tool.kind).numbers;
    const auto named = std::ranges::find(numbers, number, &sim::CommandNumber::value);
    if (named == numbers.end()) return nullptr;
    const auto limit = std::ranges::find(tool.limits, named->name, &Goal::Limit::number);
    return limit == tool.limits.end() ? nullptr : &*limit;
}

const Goal::Tool* tool_of(const Goal& goal, sim::CommandKind kind) {
    const auto tool = std::ranges::find(goal.tools, kind, &Goal::Tool::kind);
    return tool == goal.tools.end() ? nullptr : &*tool;
}

sim::Command fitted_to(const Goal& goal, sim::Command command) {
    const Goal::Tool* const tool = tool_of(goal, command.kind);
    if (!tool) return command;
    for (const sim::CommandNumber& number : sim::info_of(command.kind).numbers)
        if (const Goal::Limit* const limit = limit_of(*tool, number.value))
            command.*number.value = std::clamp(command.*number.value, limit->least, limit->most);
    if (tool->layer) command.layer = *tool->layer;
    return command;
}

std::size_t GoalUse::index_of(const Goal::Tool& tool) const {
    return static_cast<std::size_t>(&tool - goal_->tools.data());
}

std::optional<std::string> GoalUse::refusal(const sim::Command& command, float tick_s) const {
    const sim::CommandInfo& info = sim::info_of(command.kind);
    const Goal::Tool* const found = tool_of(*goal_, command.kind);
    if (!found) return fmt::format("{} is no tool of this challenge", info.name);
    const Goal::Tool& tool = *found;
    const std::size_t i = index_of(tool);
    if (goal_->zone && !goal_->zone->has(command.x, command.y))
        return fmt::format("({:.0f}, {:.0f}) is outside the zone of this challenge", command.x, command.y);
    for (const sim::CommandNumber& number : info.numbers) {
        const Goal::Limit* const limit = limit_of(tool, number.value);
        const double value = command.*number.value;
        if (!limit || (limit->least <= value && value <= limit->most)) continue;
        return fmt::format(
            "the {} of a {} is {}, {}", number.name, info.name, sim::number_text(value, number.unit),
            limit->least == limit->most ? fmt::format("and must be {}", sim::number_text(limit->least))
                                        : fmt::format("outside {} to {}", sim::number_text(limit->least),
                                                      sim::number_text(limit->most)));
    }
    if (tool.layer && command.layer != *tool.layer)
        return fmt::format("a {} must be as {}", info.name, sim::to_string(*tool.layer));
    if (tool.count && counts_[i] >= *tool.count)
        return fmt::format("no {} is left: this challenge has {}", info.name, *tool.count);
    if (tool.total && totals_[i] + cost_of(command, tick_s) > *tool.total * (1 + kRounding))
        return fmt::format("the budget of {} is {} {}, and {:.1f} {} are left", info.name,
                           sim::number_text(*tool.total), unit_of(tool.kind), *tool.total - totals_[i],
                           unit_of(tool.kind));
    return std::nullopt;
}

std::optional<std::string> GoalUse::take(const TimedCommand& timed, float tick_s) {
    if (events_ < goal_->events.size() && goal_->events[events_] == timed) {
        ++events_;
        return std::nullopt;
    }
    if (auto forbidden = refusal(timed.command, tick_s)) return forbidden;
    const std::size_t i = index_of(*tool_of(*goal_, timed.command.kind));
    ++counts_[i];
    totals_[i] += cost_of(timed.command, tick_s);
    return std::nullopt;
}

const TimedCommand* GoalUse::missing(std::int64_t tick) const {
    if (events_ == goal_->events.size() || goal_->events[events_].tick >= tick) return nullptr;
    return &goal_->events[events_];
}

std::optional<double> GoalUse::left(const Goal::Tool& tool) const {
    const std::size_t i = index_of(tool);
    if (tool.total) return std::max(*tool.total - totals_[i], 0.0);
    if (tool.count) return static_cast<double>(*tool.count - counts_[i]);
    return std::nullopt;
}

}  // namespace game
