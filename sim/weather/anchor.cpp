#include "sim/weather/anchor.h"

#include <algorithm>
#include <cmath>

#include "sim/world/edit_layers.h"
#include "sim/world/state.h"

namespace sim::weather {
namespace {

constexpr std::int64_t kTicksPerLook = 30;
constexpr double kLeastSeconds = 20, kMostSeconds = 150;
constexpr std::int64_t kCreepsBelow = 20;            // of its greatest motion, its part
constexpr float kMotionPerUnit = 1e5f;               // of R |v|², m³/s², as a whole number
constexpr float kDeposit = 2000, kDepositTop = 850;  // Pa

// Calls visit(x, y) for the vertices of tiles in which anything rolled when mass was last counted.
template <class Visit>
void each_of_rolling_tiles(const State& s, Visit&& visit) {
    const Tiles& tiles = s.tiles;
    for (int row = 0; row < tiles.rows; ++row)
        for (int column = 0; column < tiles.columns; ++column) {
            if (tiles.mass[tiles.number(column, row)].rolling == 0) continue;
            const int x1 = std::min((column + 1) * tiles.width, s.grid.nx),
                      y1 = std::min((row + 1) * tiles.height, s.grid.ny);
            for (int y = row * tiles.height; y < y1; ++y)
                for (int x = column * tiles.width; x < x1; ++x) visit(x, y);
        }
}

// Σ R |v|², in whole numbers, so that no order matters: at most 3e11 at a vertex.
std::int64_t motion_of(const State& s) {
    std::int64_t sum = 0;
    each_of_rolling_tiles(s, [&](int x, int y) {
        const float u = s.velocity_x(x, y), v = s.velocity_y(x, y);
        sum += static_cast<std::int64_t>(s.rolling(x, y) * (u * u + v * v) * kMotionPerUnit);
    });
    return sum;
}

bool only_creeps(State& s) {
    Weather& w = *s.weather;
    if (s.tick % kTicksPerLook != 0 || !s.running_commands.empty()) return false;
    const std::int64_t motion = motion_of(s);
    w.greatest_motion = std::max(w.greatest_motion, motion);
    const double seconds = static_cast<double>(s.tick - w.stirred) * static_cast<double>(s.params.tick_s);
    return (seconds >= kLeastSeconds && motion < w.greatest_motion / kCreepsBelow) || seconds >= kMostSeconds;
}

}  // namespace

bool anchor(State& s) {
    if (s.weather->anchored) return false;
    s.first_depth = s.depth;
    s.weather->anchored = true;
    return true;
}

bool settle_creep(State& s) {
    if (s.ledger.rolling == 0 || !only_creeps(s)) return false;
    each_of_rolling_tiles(s, [&](int x, int y) {
        if (s.rolling(x, y) == 0) return;
        settle_at(s, x, y, std::min(s.rolling(x, y), room_in(s.depth(x, y))));
        s.tiles.wake(x, x, y, y);
    });
    return true;
}

void reconcile(State& s) {
    Weather& w = *s.weather;
    for (int y = 0; y < s.grid.ny; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            if (s.depth(x, y) == s.first_depth(x, y)) continue;  // d₀ is that of the last anchor
            w.base(x, y) = s.depth(x, y);
            w.strength(x, y) = kDeposit;
            w.surface(x, y) = kDepositTop;
            w.water(x, y) = 0;
            w.anchored = false;
        }
}

}  // namespace sim::weather
