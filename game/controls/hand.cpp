#include "game/controls/hand.h"

#include <algorithm>
#include <cmath>

namespace game {
namespace {

constexpr double kSizeStep = 1.15, kStrengthStep = 1.25;

}  // namespace

void Hand::suit(const sim::Grid& grid) {
    const auto dx = static_cast<double>(grid.dx);
    const RadiusRange range = radius_range(grid);
    brush_ = {};
    has_acted_ = false;
    brush_.radius =
        std::clamp(std::max(0.02 * dx * (std::max(grid.nx, grid.ny) - 1), 2.5 * dx), range.least, range.most);
}

void Hand::fit(const Goal& goal) {
    const auto infos = tool_infos();
    const auto is_allowed = [&](const ToolInfo& info) { return tool_of(goal, info.plain->kind) != nullptr; };
    if (!is_allowed(info_of(brush_.tool)))
        if (const auto first = std::ranges::find_if(infos, is_allowed); first != infos.end())
            choose(first->tool);
    const Deed& deed = deed_of(brush_.tool);
    const Goal::Tool* const tool = tool_of(goal, deed.kind);
    if (!tool) return;
    if (tool->layer) brush_.standing = *tool->layer == sim::Layer::kStanding;
    const auto fit_number = [&](double sim::Command::*member, double& value) {
        if (const Goal::Limit* const limit = limit_of(*tool, member))
            value = std::clamp(value, limit->least, limit->most);
    };
    fit_number(&sim::Command::radius, brush_.radius);
    if (deed.amount != Amount::kAsItIs) return;
    const auto numbers = info_of(brush_.tool).numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) fit_number(numbers[i].member, brush_.own()[i]);
}

void Hand::resize(double steps, const sim::Grid& grid) {
    const RadiusRange range = radius_range(grid);
    brush_.radius = std::clamp(brush_.radius * std::pow(kSizeStep, steps), range.least, range.most);
}

void Hand::strengthen(double steps) {
    const auto numbers = info_of(brush_.tool).numbers;
    if (numbers.empty()) return;
    double& strength = brush_.own()[0];
    strength =
        std::clamp(strength * std::pow(kStrengthStep, steps), numbers.front().least, numbers.front().most);
}

void Hand::press(Modifiers with, glm::dvec2 at, double level, double cell) {
    stroke_.emplace(brush_.tool, with, at, level, cell);
}

void Hand::move_to(std::optional<glm::dvec2> at) {
    if (stroke_ && !stroke_->released()) stroke_->move_to(at);
}

void Hand::release() {
    if (stroke_) stroke_->release();
}

std::optional<std::string> Hand::set_number(const sim::Params& params, std::size_t param, double value) {
    sim::Command command;
    command.kind = sim::CommandKind::kSet;
    command.param = param;
    command.value = value;
    numbers_.push_back(command);
    auto fault = sim::fault_of(command);
    if (!fault) fault = sim::fault_after(params, numbers_);
    if (fault) numbers_.pop_back();
    return fault;
}

bool Hand::drop_numbers() {
    const bool any = !numbers_.empty();
    numbers_.clear();
    return any;
}

std::span<const sim::Command> Hand::commands_of(int tick, int ticks, double tick_s, bool may_act) {
    commands_.clear();
    if (may_act) std::swap(commands_, numbers_);
    if (stroke_) stroke_->commands_of(tick, ticks, brush_, tick_s, commands_);
    has_acted_ |= !commands_.empty();
    return commands_;
}

bool Hand::would_act(double tick_s) {
    if (!stroke_) return false;
    commands_.clear();
    Stroke(*stroke_).commands_of(0, 1, brush_, tick_s, commands_);
    return !commands_.empty();
}

void Hand::arrive(double share) {
    if (!stroke_) return;
    stroke_->arrive(share);
    if (const auto turn = stroke_->turn()) brush_.turn = *turn;
    if (stroke_->released()) stroke_.reset();
}

}  // namespace game
