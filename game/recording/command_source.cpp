#include "game/recording/command_source.h"

#include <algorithm>

#include <fmt/format.h>

#include "sim/core/float_environment.h"
#include "sim/world/command.h"
#include "sim/world/thing_places.h"
#include "sim/world/things.h"
#include "sim/world/weather.h"

namespace game {

std::span<const sim::Command> CommandSource::due(const sim::State& state,
                                                 std::span<const TimedCommand> known) {
    begin(state);
    add_known(known);
    return commands();
}

void CommandSource::begin(const sim::State& state) {
    state_ = &state;
    commands_.clear();
    settled_ = 0;
}

void CommandSource::add_known(std::span<const TimedCommand> known) {
    for (const TimedCommand& due : commands_at(known, state_->tick)) commands_.push_back(due.command);
}

void CommandSource::add_new(std::span<const sim::Command> commands) {
    const std::size_t given = std::min(commands_.size(), sim::kMostCommandsPerTick),
                      running = std::min(state_->running_commands.size() + commands_.size(),
                                         sim::kMostRunningCommands);
    const std::size_t room = std::min(sim::kMostCommandsPerTick - given, sim::kMostRunningCommands - running);
    const auto fit = commands.first(std::min(commands.size(), room));
    commands_.insert(commands_.end(), fit.begin(), fit.end());
}

Outcome<void> CommandSource::leave_out_clashing() {
    std::optional<std::string> reason;
    if (const auto fault = sim::fault_after(state_->params, commands_)) {
        const auto is_set = [](const sim::Command& command) {
            return command.kind == sim::CommandKind::kSet;
        };
        const auto first = commands_.begin() + static_cast<std::ptrdiff_t>(settled_);
        commands_.erase(std::remove_if(first, commands_.end(), is_set), commands_.end());
        reason = fmt::format("Parameter not set: {}", *fault);
    }
    if (const auto fault = sim::fault_of_visits(state_->grid, commands_)) {
        commands_.resize(settled_);
        reason = fmt::format("Not done: {}", *fault);
    }
    const auto leave_out = [&](const auto& fault) {
        if (!reason) reason = fmt::format("Not done: {}", fault.fact);
        commands_.erase(commands_.begin() + static_cast<std::ptrdiff_t>(fault.command));
    };
    while (const auto fault = sim::fault_of_things(*state_, commands_)) leave_out(*fault);
    while (const auto fault = sim::fault_of_weather(sim::weather_of(*state_), commands_)) leave_out(*fault);
    settled_ = commands_.size();
    return reason ? unusable(*reason) : Outcome<void>();
}

namespace {

tl::unexpected<Failure> refused(std::int64_t tick, const std::string& fault) {
    return unusable(fmt::format("tick {}: {}", tick, fault));
}

}  // namespace

Outcome<void> check_ahead(const sim::State& state, std::span<const TimedCommand> commands) {
    for (const TimedCommand& each : commands) {
        if (const auto fault = sim::fault_of(each.command, state.mixture.has_value()))
            return refused(each.tick, *fault);
        if (const auto fault = sim::fault_of_place(state, each.command)) return refused(each.tick, *fault);
    }
    return {};
}

Outcome<void> check_tick(const sim::State& state, std::span<const sim::Command> commands) {
    for (const sim::Command& command : commands)
        if (const auto fault = sim::fault_of(command, state.mixture.has_value()))
            return refused(state.tick, *fault);
    if (const auto fault =
            sim::fault_of_counts(commands.size(), state.running_commands.size() + commands.size()))
        return refused(state.tick, *fault);
    if (const auto fault = sim::fault_of_visits(state.grid, commands)) return refused(state.tick, *fault);
    if (const auto fault = sim::fault_after(state.params, commands)) return refused(state.tick, *fault);
    if (const auto fault = sim::fault_of_things(state, commands)) return refused(state.tick, fault->fact);
    if (const auto fault = sim::fault_of_weather(sim::weather_of(state), commands))
        return refused(state.tick, fault->fact);
    if (const auto fault = sim::float_environment_fault())
        return machine_fails(
            fmt::format("tick {}: {}, so a replay would not be bit-identical", state.tick, *fault));
    return {};
}

}  // namespace game
