#include "game/analysis/measures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "game/scene/surface.h"
#include "sim/core/angle.h"
#include "sim/world/disc.h"
#include "sim/world/on_ground.h"

namespace game {

std::size_t index_of(const sim::Grid& grid, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(x);
}

namespace {

// m, in plan.
double distance(terrains::LocalPoint from, terrains::LocalPoint to) {
    const double x = to.x - from.x, y = to.y - from.y;
    return std::sqrt(x * x + y * y);
}

double ground_height(const Scenario& scenario, std::size_t i) {
    return static_cast<double>(scenario.bedrock[i]) + static_cast<double>(scenario.depth[i]);
}

// Computes run-out, fall and reach; leaves them if nothing moved. What let go by itself, as soil does that was wetted or
// undercut, began at the top of its extent.
void measure_line(const Scenario& scenario, const std::vector<std::uint8_t>& released,
                  const std::vector<std::uint8_t>& extent, Measures& measures) {
    const sim::Grid& grid = scenario.grid;
    const auto place = [&](int x, int y) {
        return terrains::LocalPoint{x * static_cast<double>(grid.dx), y * static_cast<double>(grid.dx)};
    };
    const bool by_itself = std::ranges::find(released, std::uint8_t{1}) == released.end();
    const std::vector<std::uint8_t>& began = by_itself ? extent : released;
    double highest = -1e30, top_height = 0;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x)
            if (const std::size_t i = index_of(grid, x, y);
                began[i] && ground_height(scenario, i) > highest) {
                highest = top_height = ground_height(scenario, i);
                measures.top = place(x, y);
            }
    if (highest == -1e30) return;
    measures.toe = measures.top;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) {
            const std::size_t i = index_of(grid, x, y);
            if (!extent[i]) continue;
            const auto here = place(x, y);
            const double away = distance(here, measures.top);
            if (away <= measures.run_out) continue;
            measures.run_out = away;
            measures.fall = top_height - ground_height(scenario, i);
            measures.toe = here;
        }
    if (measures.run_out > 0) measures.reach_deg = sim::degrees_of_slope(measures.fall, measures.run_out);
}

// Whether no square of Measures::kLeastWidth cells fits into an area that has a vertex at all.
bool is_narrow(const sim::Grid& grid, const std::vector<std::uint8_t>& inside) {
    // Width of the greatest square whose north-east corner is this vertex, for two rows.
    const auto nx = static_cast<std::size_t>(grid.nx);
    std::vector<int> south(nx), here(nx);
    int greatest = 0;
    for (int y = 0; y < grid.ny; ++y, std::swap(south, here))
        for (std::size_t x = 0; x < nx; ++x) {
            const bool is_inside = inside[static_cast<std::size_t>(y) * nx + x];
            const int beside = y == 0 || x == 0 ? 0 : std::min({south[x - 1], south[x], here[x - 1]});
            here[x] = is_inside ? beside + 1 : 0;
            greatest = std::max(greatest, here[x]);
        }
    return greatest > 0 && greatest < Measures::kLeastWidth;
}

// The vertices around the greatest value that are connected with it and have at least half of it.
std::vector<std::uint8_t> heart_of(const sim::Grid& grid, const std::vector<float>& depth) {
    std::vector<std::uint8_t> inside(depth.size());
    const auto deepest = std::ranges::max_element(depth);
    if (*deepest == 0) return inside;
    std::vector<std::size_t> open;
    const auto add = [&](std::size_t i) {
        if (!inside[i] && 2 * depth[i] >= *deepest) inside[i] = 1, open.push_back(i);
    };
    const auto nx = static_cast<std::size_t>(grid.nx);
    add(static_cast<std::size_t>(deepest - depth.begin()));
    while (!open.empty()) {
        const std::size_t i = open.back(), x = i % nx;
        open.pop_back();
        if (x > 0) add(i - 1);
        if (x + 1 < nx) add(i + 1);
        if (i >= nx) add(i - nx);
        if (i + nx < depth.size()) add(i + nx);
    }
    return inside;
}

// How much the surface was raised at each vertex.
std::vector<float> change_of(const Scenario& scenario, const sim::State& state) {
    std::vector<float> change(scenario.grid.size());
    for (int y = 0; y < scenario.grid.ny; ++y)
        for (int x = 0; x < scenario.grid.nx; ++x) {
            const std::size_t i = index_of(scenario.grid, x, y);
            change[i] = (state.depth(x, y) - scenario.depth[i]) + (state.rolling(x, y) - scenario.rolling[i]);
        }
    return change;
}

Measures::Change measure_change(const sim::Grid& grid, const std::vector<float>& change) {
    struct Part {
        double volume = 0, x = 0, y = 0;
        terrains::LocalPoint middle() const {
            return volume > 0 ? terrains::LocalPoint{x / volume, y / volume} : terrains::LocalPoint{};
        }
    } raised, lowered;
    const double dx = grid.dx;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) {
            const float metres = change[index_of(grid, x, y)];
            const double volume = std::fabs(static_cast<double>(metres)) * grid.cell_area();
            Part& part = metres > 0 ? raised : lowered;
            part.volume += volume, part.x += volume * x * dx, part.y += volume * y * dx;
        }
    const auto from = lowered.middle(), to = raised.middle();
    return {raised.volume, from, to, distance(from, to)};
}

std::vector<std::uint8_t> changed(const std::vector<float>& change) {
    std::vector<std::uint8_t> flags(change.size());
    std::transform(change.begin(), change.end(), flags.begin(),
                   [](float metres) { return std::fabs(metres) >= Measures::kChanged; });
    return flags;
}

}  // namespace

std::optional<double> overlap_of(const std::vector<std::uint8_t>& one,
                                 const std::vector<std::uint8_t>& other) {
    std::size_t both = 0, either = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        both += one[i] && other[i];
        either += one[i] || other[i];
    }
    if (either == 0) return std::nullopt;
    return static_cast<double>(both) / static_cast<double>(either);
}

Measures measure(const Scenario& scenario, const Session& session, const std::vector<std::uint8_t>& released,
                 const terrains::Reference& reference) {
    const sim::Grid& grid = scenario.grid;
    const Peaks& peaks = session.peaks();
    const double cell = grid.cell_area();
    Measures measures;
    std::vector<std::uint8_t> extent(grid.size());
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) {
            const std::size_t i = index_of(grid, x, y);
            extent[i] = peaks.depth[i] >= Measures::kExtentDepth;
            measures.extent_area += extent[i] * cell;
            measures.peak_depth = std::max(measures.peak_depth, static_cast<double>(peaks.depth[i]));
            measures.peak_speed_slope =
                std::max(measures.peak_speed_slope, static_cast<double>(peaks.speed_slope[i]));
            measures.peak_speed_plan =
                std::max(measures.peak_speed_plan, static_cast<double>(peaks.speed_plan[i]));
            const double change =
                static_cast<double>(session.state().depth(x, y)) - static_cast<double>(scenario.depth[i]);
            (change < 0 ? measures.eroded : measures.deposited) += std::fabs(change) * cell;
        }
    measures.peak_thickness = std::ranges::max(peak_thickness_of(scenario, peaks));
    if (!peaks.pressure.empty())
        measures.peak_pressure = *std::max_element(peaks.pressure.begin(), peaks.pressure.end());
    measures.narrow_release = is_narrow(grid, released);
    measures.narrow_flow = is_narrow(grid, heart_of(grid, peaks.depth));
    if (!reference.extent.empty()) measures.overlap = overlap_of(extent, reference.extent);
    if (!reference.change.empty()) {
        const std::vector<float> change = change_of(scenario, session.state());
        measures.overlap = overlap_of(changed(change), changed(reference.change));
        const auto here = measure_change(grid, change), observed = measure_change(grid, reference.change);
        measures.changes = {here, observed, distance(here.to, observed.to)};
    }
    measure_line(scenario, released, extent, measures);
    return measures;
}

std::vector<float> peak_thickness_of(const Scenario& scenario, const Peaks& peaks) {
    const sim::State first = sim::make_state(initial_state_of(scenario), scenario.params);
    const sim::View world = sim::view(first);
    std::vector<float> thickness = peaks.depth;
    std::size_t i = 0;
    for (int y = 0; y < scenario.grid.ny; ++y)
        for (int x = 0; x < scenario.grid.nx; ++x, ++i) {
            if (thickness[i] == 0) continue;
            const glm::vec2 slope = ground_slope(world, x, y);
            thickness[i] /= std::sqrt(1 + slope.x * slope.x + slope.y * slope.y);
        }
    return thickness;
}

std::vector<std::uint8_t> release_area(const Scenario& scenario, std::span<const TimedCommand> commands) {
    const sim::Grid& grid = scenario.grid;
    std::vector<std::uint8_t> released(grid.size());
    for (std::size_t i = 0; i < released.size(); ++i) released[i] = scenario.rolling[i] > 0;
    std::optional<sim::State> first;  // for commands that choose slopes
    for (const TimedCommand& timed : commands) {
        const sim::Command& c = timed.command;
        if (c.kind != sim::CommandKind::kPour && c.kind != sim::CommandKind::kBlast) continue;
        const sim::SlopeFilter slopes(c);
        if (!slopes.takes_all() && !first)
            first = sim::make_state(initial_state_of(scenario), scenario.params);
        sim::Disc(c, grid.dx).each_vertex(grid, sim::Profile::kDisc, [&](int x, int y, double) {
            if (slopes.takes_all() || slopes.takes(*first, x, y)) released[index_of(grid, x, y)] = 1;
        });
    }
    return released;
}

}  // namespace game
