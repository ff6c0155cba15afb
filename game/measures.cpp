#include "game/measures.h"

#include <algorithm>
#include <cmath>

#include "sim/disc.h"

namespace game {
namespace {

std::size_t index(const sim::Grid& grid, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(x);
}

double ground_height(const Start& start, std::size_t i) {
    return static_cast<double>(start.bedrock[i]) + static_cast<double>(start.depth[i]);
}

// Run-out, fall and reach; nothing where nothing was released or nothing moved.
void measure_line(const Start& start, const std::vector<std::uint8_t>& released,
                  const std::vector<std::uint8_t>& extent, Measures& measures) {
    const sim::Grid& grid = start.grid;
    const auto place = [&](int x, int y) {
        return terrains::LocalPoint{x * static_cast<double>(grid.dx), y * static_cast<double>(grid.dx)};
    };
    double highest = -1e30, top_height = 0;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x)
            if (const std::size_t i = index(grid, x, y); released[i] && ground_height(start, i) > highest) {
                highest = top_height = ground_height(start, i);
                measures.top = place(x, y);
            }
    if (highest == -1e30) return;
    measures.toe = measures.top;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) {
            const std::size_t i = index(grid, x, y);
            if (!extent[i]) continue;
            const auto here = place(x, y);
            const double away = std::hypot(here.x - measures.top.x, here.y - measures.top.y);
            if (away <= measures.run_out) continue;
            measures.run_out = away;
            measures.fall = top_height - ground_height(start, i);
            measures.toe = here;
        }
    if (measures.run_out > 0)
        measures.reach_deg = std::atan2(measures.fall, measures.run_out) * 180 / 3.14159265358979323846;
}

}  // namespace

Measures measure(const Start& start, const Session& session, const std::vector<std::uint8_t>& released,
                 const std::vector<std::uint8_t>& reference) {
    const sim::Grid& grid = start.grid;
    const Peaks& peaks = session.peaks();
    const double cell = grid.cell_area();
    Measures measures;
    std::vector<std::uint8_t> extent(grid.size());
    std::size_t both = 0, either = 0;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) {
            const std::size_t i = index(grid, x, y);
            extent[i] = peaks.depth[i] >= Measures::kExtentDepth;
            measures.extent_area += extent[i] * cell;
            measures.peak_depth = std::max(measures.peak_depth, static_cast<double>(peaks.depth[i]));
            measures.peak_speed = std::max(measures.peak_speed, static_cast<double>(peaks.speed[i]));
            const double change =
                static_cast<double>(session.state().depth(x, y)) - static_cast<double>(start.depth[i]);
            (change < 0 ? measures.eroded : measures.deposited) += std::fabs(change) * cell;
            if (reference.empty()) continue;
            both += extent[i] && reference[i];
            either += extent[i] || reference[i];
        }
    if (either > 0) measures.overlap = static_cast<double>(both) / static_cast<double>(either);
    measure_line(start, released, extent, measures);
    return measures;
}

std::vector<std::uint8_t> release_area(const Start& start, std::span<const TimedCommand> commands) {
    const sim::Grid& grid = start.grid;
    std::vector<std::uint8_t> released(grid.size());
    for (std::size_t i = 0; i < released.size(); ++i) released[i] = start.rolling[i] > 0;
    for (const TimedCommand& timed : commands) {
        const sim::Command& c = timed.command;
        if (c.kind != sim::CommandKind::kPour && c.kind != sim::CommandKind::kBlast) continue;
        sim::Disc(c, grid.dx).each_vertex(grid, sim::Profile::kDisc, [&](int x, int y, double) {
            released[index(grid, x, y)] = 1;
        });
    }
    return released;
}

}  // namespace game
