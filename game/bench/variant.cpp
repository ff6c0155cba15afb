#include "game/bench/variant.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "game/scene/material.h"
#include "terrains/resample.h"

namespace game {
namespace {

// Transfers fields from one grid to another.
class Resampler {
  public:
    Resampler(const Scenario& from, const sim::Grid& to) : from_(from), to_(to) {}

    terrains::PlaneFit::Fitted fit(const std::vector<float>& values) const {
        const double dx = from_.grid.dx, reach = std::max(dx, static_cast<double>(to_.dx));
        terrains::PlaneFit fit(to_, reach, reach, dx * dx);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const auto column = i % static_cast<std::size_t>(from_.grid.nx);
            const auto row = i / static_cast<std::size_t>(from_.grid.nx);
            const double x = static_cast<double>(column) * dx, y = static_cast<double>(row) * dx;
            if (from_.has_data[i] != 0)
                fit.add(x, y, static_cast<double>(values[i]));
            else
                fit.add_void(x, y);
        }
        return fit.finish();
    }

    // Never deeper than the original, and zero where there is no data.
    std::vector<float> layer(const std::vector<float>& depth) const {
        if (depth.empty()) return {};
        const float most = *std::max_element(depth.begin(), depth.end());
        if (most == 0) return std::vector<float>(to_.size(), 0.f);
        std::vector<float> values = fit(depth).surface;
        for (float& value : values) value = std::clamp(value, 0.f, most);
        return values;
    }

  private:
    const Scenario& from_;
    sim::Grid to_;
};

Outcome<sim::Params> numbers_of(const std::string& material, const sim::Params& recorded,
                                const BenchPhysics& physics) {
    auto loaded = load_material(material, physics.model);
    if (!loaded) return tl::unexpected(loaded.error());
    sim::Params params = loaded->params;
    params.scheme = physics.scheme;
    params.tick_s = recorded.tick_s;
    params.borders = recorded.borders;
    return params;
}

}  // namespace

std::optional<BenchPhysics> bench_physics_named(std::string_view name) {
    for (const BenchPhysics& physics : kBenchPhysics)
        if (physics.name == name) return physics;
    return std::nullopt;
}

std::string bench_physics_names() {
    std::string names;
    for (const BenchPhysics& physics : kBenchPhysics)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", physics.name);
    return names;
}

bool is_own(const Scenario& scenario, const BenchPhysics& physics) {
    return scenario.params.model == physics.model &&
           (physics.model != sim::Model::kBcre || scenario.params.scheme == physics.scheme);
}

Outcome<Scenario> in_physics(Scenario scenario, const BenchPhysics& physics) {
    if (is_own(scenario, physics)) return scenario;
    if (scenario.params.model == physics.model) {
        scenario.params.scheme = physics.scheme;
        if (scenario.lower) scenario.lower->params.scheme = physics.scheme;
        return scenario;
    }
    const auto params = numbers_of(scenario.material, scenario.params, physics);
    if (!params) return tl::unexpected(params.error());
    if (scenario.lower) {
        const auto lower = numbers_of(scenario.lower->material, scenario.params, physics);
        if (!lower) return tl::unexpected(lower.error());
        scenario.lower->params = *lower;
    }
    scenario.params = *params;
    return scenario;
}

int squares_of(const Scenario& scenario) {
    return std::max(scenario.grid.nx, scenario.grid.ny) - 1;
}

Outcome<Scenario> on_grid(Scenario scenario, int squares, const Memory& memory) {
    if (squares == squares_of(scenario)) {
        if (auto allowed = memory.allows(scenario.grid, scenario.lower.has_value()); !allowed)
            return unusable(fmt::format("{}: {}", scenario.title, allowed.error()));
        return scenario;
    }
    const bool is_mixed =
        scenario.lower && !(scenario.lower->settled.empty() && scenario.lower->rolling.empty());
    if (is_mixed || !scenario.standing.forest.empty() || !scenario.standing.earth.empty())
        return unusable(
            fmt::format("{}: has forest, earth or mixed layers of a grid of {} squares, the only "
                        "one to measure it on",
                        scenario.title, squares_of(scenario)));
    const double dx = scenario.grid.dx;
    const auto grid = terrains::grid_over((scenario.grid.nx - 1) * dx, (scenario.grid.ny - 1) * dx,
                                          {squares, [&](const sim::Grid& wanted) {
                                               return memory.allows(wanted, scenario.lower.has_value());
                                           }});
    if (!grid) return unusable(fmt::format("{}: {}", scenario.title, grid.error()));
    const Resampler to(scenario, *grid);
    auto bedrock = to.fit(scenario.bedrock);
    if (std::count(bedrock.has_data.begin(), bedrock.has_data.end(), 0) ==
        static_cast<std::ptrdiff_t>(grid->size()))
        return unusable(fmt::format("{}: a grid of {} squares leaves no ground", scenario.title, squares));
    terrains::fill_voids(*grid, bedrock.has_data, bedrock.surface);
    scenario.depth = to.layer(scenario.depth);
    scenario.rolling = to.layer(scenario.rolling);
    if (scenario.lower) {
        scenario.lower->depth = to.layer(scenario.lower->depth);
        for (std::size_t i = 0; i < grid->size(); ++i)
            scenario.lower->depth[i] = std::min(scenario.lower->depth[i], scenario.depth[i]);
    }
    scenario.bedrock = std::move(bedrock.surface);
    scenario.has_data = std::move(bedrock.has_data);
    scenario.grid = *grid;
    return scenario;
}

Outcome<Scenario> scenario_of(const Recording& recording, int squares, const BenchPhysics& physics,
                              const Memory& memory) {
    auto scenario = in_physics(recording.header.scenario, physics);
    if (scenario) scenario = on_grid(std::move(*scenario), squares, memory);
    if (!scenario) return scenario;
    if (const auto fault = fault_of_commands(scenario->params, recording.commands))
        return unusable(fmt::format("{} in {}: {}", scenario->scene, physics.name, *fault));
    return scenario;
}

bool has_states_of(const Recording& recording, int squares, const BenchPhysics& physics) {
    const Header& header = recording.header;
    return squares == squares_of(header.scenario) && is_own(header.scenario, physics) &&
           is_comparable(header);
}

}  // namespace game
