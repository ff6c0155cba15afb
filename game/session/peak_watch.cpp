#include "game/session/peak_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "game/scene/surface.h"

namespace game {

PeakWatch::PeakWatch(const sim::State& state, const std::optional<Densities>& densities)
    : densities_(densities), active_in_tile_(state.tiles.awake.size()) {
    peaks_.depth.assign(state.grid.size(), 0.f);
    peaks_.speed_plan.assign(state.grid.size(), 0.f);
    peaks_.speed_slope.assign(state.grid.size(), 0.f);
    if (densities_) peaks_.pressure.assign(state.grid.size(), 0.f);
    peaks_.arrival.assign(state.grid.size(), Peaks::kNever);
}

void PeakWatch::see(sim::State& state) {
    sim::Tiles& tiles = state.tiles;
    const auto ticks = static_cast<std::uint32_t>(state.tick);
    const sim::View world = sim::view(state);
    active_ = {};
    for (int row = 0; row < tiles.rows; ++row)
        for (int column = 0; column < tiles.columns; ++column) {
            const std::size_t tile = tiles.number(column, row);
            if (std::exchange(tiles.unseen[tile], std::uint8_t{0})) {
                const int x0 = column * tiles.width, y0 = row * tiles.height;
                const bool is_empty = !tiles.uncounted[tile] && tiles.mass[tile].rolling == 0;
                active_in_tile_[tile] =
                    is_empty ? Active{}
                             : see_tile(world, ticks, x0, std::min(x0 + tiles.width, state.grid.nx), y0,
                                        std::min(y0 + tiles.height, state.grid.ny));
            }
            active_.cells += active_in_tile_[tile].cells;
            active_.energy += active_in_tile_[tile].energy;
        }
}

// Vertices x0 … x1-1 by y0 … y1-1.
PeakWatch::Active PeakWatch::see_tile(const sim::View& world, std::uint32_t ticks, int x0, int x1, int y0,
                                      int y1) {
    Active active;
    for (int y = y0; y < y1; ++y) {
        const float* rolling = world.rolling.row(y);
        const float *u = world.velocity_x.row(y), *v = world.velocity_y.row(y);
        std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(world.grid.nx) +
                        static_cast<std::size_t>(x0);
        for (int x = x0; x < x1; ++x, ++i) {
            if (rolling[x] == 0) continue;
            ++active.cells;
            peaks_.depth[i] = std::max(peaks_.depth[i], rolling[x]);
            if (rolling[x] < Peaks::kVisible) continue;
            peaks_.arrival[i] = std::min(peaks_.arrival[i], ticks);
            if (u[x] == 0 && v[x] == 0) continue;
            const double along = speed_along_slope({u[x], v[x]}, ground_slope(world, x, y));
            active.energy += std::llrint(static_cast<double>(rolling[x]) * (along * along) / kEnergyUnit);
            peaks_.speed_plan[i] = std::max(peaks_.speed_plan[i], std::sqrt(u[x] * u[x] + v[x] * v[x]));
            peaks_.speed_slope[i] = std::max(peaks_.speed_slope[i], static_cast<float>(along));
            if (!densities_) continue;
            const double share = world.mixture ? static_cast<double>(sim::share_in_rolling(world, x, y)) : 0;
            peaks_.pressure[i] = std::max(peaks_.pressure[i],
                                          static_cast<float>(impact_pressure(densities_->of(share), along)));
        }
    }
    return active;
}

}  // namespace game
