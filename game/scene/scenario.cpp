#include "game/scene/scenario.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

#include <fmt/format.h>

#define XXH_STATIC_LINKING_ONLY  // for a digest on the stack
#include <xxhash.h>

#include "game/scene/pressure.h"

namespace game {

std::span<const TimedCommand> commands_before(std::span<const TimedCommand> commands, std::int64_t tick) {
    return commands.first(commands.size() - commands_from(commands, tick).size());
}

std::span<const TimedCommand> commands_from(std::span<const TimedCommand> commands, std::int64_t tick) {
    return {std::ranges::lower_bound(commands, tick, {}, &TimedCommand::tick), commands.end()};
}

std::span<const TimedCommand> commands_at(std::span<const TimedCommand> commands, std::int64_t tick) {
    return commands_before(commands_from(commands, tick), tick + 1);
}

namespace {

// Counts the commands of a tick, and those still active in it.
class CommandCount {
  public:
    explicit CommandCount(float tick_s) : tick_s_(tick_s) {}

    // Takes commands sorted by tick.
    std::optional<std::string> add(const TimedCommand& timed) {
        if (timed.tick != tick_) in_tick_ = 0;
        tick_ = timed.tick;
        while (!ends_.empty() && ends_.top() <= tick_) ends_.pop();
        ends_.push(tick_ + sim::ticks_of(timed.command, tick_s_));
        return sim::fault_of_counts(++in_tick_, ends_.size());
    }

  private:
    float tick_s_;
    std::int64_t tick_ = -1;
    std::size_t in_tick_ = 0;
    std::priority_queue<std::int64_t, std::vector<std::int64_t>, std::greater<>> ends_;  // earliest first
};

}  // namespace

std::optional<std::string> fault_of_commands(sim::Params params, std::span<const TimedCommand> commands) {
    std::vector<sim::Command> sets;  // of one tick; they may be consistent only together
    CommandCount count(params.tick_s);
    for (std::size_t i = 0; i < commands.size(); ++i) {
        if (const auto fault = count.add(commands[i]))
            return fmt::format("at tick {}: {}", commands[i].tick, *fault);
        if (commands[i].command.kind == sim::CommandKind::kSet) sets.push_back(commands[i].command);
        const bool last_of_tick = i + 1 == commands.size() || commands[i + 1].tick != commands[i].tick;
        if (!last_of_tick || sets.empty()) continue;
        if (const auto fault = sim::fault_after(params, sets))
            return fmt::format("at tick {}: {}", commands[i].tick, *fault);
        for (const sim::Command& set : sets) sim::set_number(params, set);
        sets.clear();
    }
    return std::nullopt;
}

void set_ground(Scenario& scenario, const terrains::Terrain& terrain) {
    scenario.terrain = terrain.name;
    scenario.licence = terrain.licence;
    scenario.grid = terrain.grid;
    scenario.georeference = terrain.georeference;
    scenario.has_data = terrain.has_data;
    scenario.depth = terrain.cover;
    scenario.rolling.assign(terrain.grid.size(), 0.f);
    scenario.datum = std::floor(*std::min_element(terrain.surface.begin(), terrain.surface.end()));
    scenario.bedrock.resize(terrain.grid.size());
    for (std::size_t i = 0; i < scenario.bedrock.size(); ++i)
        scenario.bedrock[i] = static_cast<float>(static_cast<double>(terrain.surface[i]) - scenario.datum -
                                                 static_cast<double>(terrain.cover[i]));
    leave_old_cover_on_bare_ground(scenario);
}

void leave_old_cover_on_bare_ground(Scenario& scenario) {
    const bool bare =
        std::all_of(scenario.depth.begin(), scenario.depth.end(), [](float depth) { return depth == 0; });
    if (!bare || scenario.flow) scenario.look.old_cover_m = 0;
}

bool is_bare(const Scenario& scenario, const sim::State& state) {
    const sim::Ledger& ledger = state.ledger;
    return !scenario.flow && ledger.initial == 0 && ledger.standing == 0 && ledger.rolling == 0;
}

sim::InitialState initial_state_of(const Scenario& scenario) {
    sim::InitialState world{scenario.grid,  scenario.datum,   scenario.bedrock,
                            scenario.depth, scenario.rolling, scenario.has_data};
    if (const auto& lower = scenario.lower)
        world.lower = sim::InitialState::Lower{lower->params, lower->depth, lower->settled, lower->rolling};
    if (const auto densities = densities_of(scenario)) {
        world.density = static_cast<float>(densities->upper);
        world.lower_density = static_cast<float>(densities->lower);
    }
    const Scenario::Standing& standing = scenario.standing;
    world.standing = {standing.forest, standing.placed, standing.earth_budget, standing.earth,
                      standing.water};
    world.weather = scenario.weather;
    return world;
}

std::uint64_t ground_hash(const Scenario& scenario) {
    XXH3_state_t digest;
    XXH3_64bits_reset(&digest);
    const auto add = [&](const void* bytes, std::size_t count) { XXH3_64bits_update(&digest, bytes, count); };
    add(&scenario.grid.nx, sizeof scenario.grid.nx);
    add(&scenario.grid.ny, sizeof scenario.grid.ny);
    add(&scenario.grid.dx, sizeof scenario.grid.dx);
    add(&scenario.datum, sizeof scenario.datum);
    for (const std::vector<float>* field : {&scenario.bedrock, &scenario.depth, &scenario.rolling})
        add(field->data(), field->size() * sizeof(float));
    add(scenario.has_data.data(), scenario.has_data.size());
    if (scenario.lower) add(scenario.lower->depth.data(), scenario.lower->depth.size() * sizeof(float));
    return XXH3_64bits_digest(&digest);
}

}  // namespace game
