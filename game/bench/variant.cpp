#include "game/bench/variant.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "game/scene/material.h"
#include "terrains/resample.h"

namespace game {
namespace {

// Brings one field after the other from a grid to another.
class Resampler {
  public:
    Resampler(const Start& from, const sim::Grid& to) : from_(from), to_(to) {}

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

    // No deeper than it ever was, nothing where nobody knows the ground.
    std::vector<float> layer(const std::vector<float>& depth) const {
        if (depth.empty()) return {};
        const float most = *std::max_element(depth.begin(), depth.end());
        if (most == 0) return std::vector<float>(to_.size(), 0.f);
        std::vector<float> values = fit(depth).surface;
        for (float& value : values) value = std::clamp(value, 0.f, most);
        return values;
    }

  private:
    const Start& from_;
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

bool is_own(const Start& start, const BenchPhysics& physics) {
    return start.params.model == physics.model &&
           (physics.model == sim::Model::kBcreInertial || start.params.scheme == physics.scheme);
}

Outcome<Start> in_physics(Start start, const BenchPhysics& physics) {
    if (is_own(start, physics)) return start;
    if (start.params.model == physics.model) {
        start.params.scheme = physics.scheme;
        if (start.lower) start.lower->params.scheme = physics.scheme;
        return start;
    }
    const auto params = numbers_of(start.material, start.params, physics);
    if (!params) return tl::unexpected(params.error());
    if (start.lower) {
        const auto lower = numbers_of(start.lower->material, start.params, physics);
        if (!lower) return tl::unexpected(lower.error());
        start.lower->params = *lower;
    }
    start.params = *params;
    return start;
}

int squares_of(const Start& start) {
    return std::max(start.grid.nx, start.grid.ny) - 1;
}

Outcome<Start> on_grid(Start start, int squares, const Memory& memory) {
    if (squares == squares_of(start)) return start;
    const double dx = start.grid.dx;
    const auto grid = terrains::grid_over(
        (start.grid.nx - 1) * dx, (start.grid.ny - 1) * dx,
        {squares, [&](const sim::Grid& wanted) { return memory.allows(wanted, start.lower.has_value()); }});
    if (!grid) return unusable(fmt::format("{}: {}", start.title, grid.error()));
    const Resampler to(start, *grid);
    auto bedrock = to.fit(start.bedrock);
    if (std::count(bedrock.has_data.begin(), bedrock.has_data.end(), 0) ==
        static_cast<std::ptrdiff_t>(grid->size()))
        return unusable(fmt::format("{}: no ground is left on a grid of {} squares", start.title, squares));
    terrains::fill_voids(*grid, bedrock.has_data, bedrock.surface);
    start.depth = to.layer(start.depth);
    start.rolling = to.layer(start.rolling);
    if (start.lower) {
        start.lower->depth = to.layer(start.lower->depth);
        for (std::size_t i = 0; i < grid->size(); ++i)
            start.lower->depth[i] = std::min(start.lower->depth[i], start.depth[i]);
    }
    start.bedrock = std::move(bedrock.surface);
    start.has_data = std::move(bedrock.has_data);
    start.grid = *grid;
    return start;
}

Outcome<Start> start_of(const Recording& recording, int squares, const BenchPhysics& physics,
                        const Memory& memory) {
    auto start = in_physics(recording.header.start, physics);
    if (start) start = on_grid(std::move(*start), squares, memory);
    if (!start) return start;
    if (const auto fault = fault_of_commands(start->params, recording.commands))
        return unusable(fmt::format("{} in {}: {}", start->scene, physics.name, *fault));
    return start;
}

bool has_states_of(const Recording& recording, int squares, const BenchPhysics& physics) {
    const Header& header = recording.header;
    return squares == squares_of(header.start) && is_own(header.start, physics) &&
           header.physics_version == kPhysicsVersion;
}

}  // namespace game
