#include "sim/load_things.h"

#include <algorithm>
#include <cmath>

#include "sim/ground.h"
#include "sim/momentum/fields.h"
#include "sim/world/mixture.h"
#include "sim/world/state.h"

namespace sim {
namespace {

constexpr double kFullLoadDepth = 1;  // m, from which on a flow presses on all of a wall

// The flow at a vertex.
struct Flow {
    double density;   // kg/m³
    double normal;    // h, m
    double u, v;      // m/s
    double per_plan;  // speed along the slope over that in plan
};

Flow flow_at(const State& s, int x, int y) {
    const bool is_smoothed = has_momentum(s.params.model);
    const auto height = [&](int i, int j) {
        return static_cast<double>(s.things->natural(i, j)) +
               static_cast<double>(is_smoothed ? s.smooth_depth(i, j) : s.depth(i, j));
    };
    const double two_cells = 2 * static_cast<double>(s.grid.dx);
    const double bx = (height(x + 1, y) - height(x - 1, y)) / two_cells,
                 by = (height(x, y + 1) - height(x, y - 1)) / two_cells;
    const auto u = static_cast<double>(s.velocity_x(x, y)), v = static_cast<double>(s.velocity_y(x, y));
    const double plan = u * u + v * v, rises = bx * u + by * v;
    auto density = static_cast<double>(s.params.density);
    if (s.mixture) {
        const auto share = static_cast<double>(share_in_rolling(view(s), x, y));
        density = density * (1 - share) + static_cast<double>(s.mixture->lower.density) * share;
    }
    return {density, static_cast<double>(s.rolling(x, y)) / std::sqrt(1 + bx * bx + by * by), u, v,
            plan > 0 ? std::sqrt((plan + rises * rises) / plan) : 1};
}

// q of a flow, Pa: toward a wall, or on a body that it passes on all sides.
double load_of(const Flow& flow, const LoadedVertex& at) {
    const bool any_way = at.to_x == 0 && at.to_y == 0;
    const double toward = any_way ? std::sqrt(flow.u * flow.u + flow.v * flow.v)
                                  : std::max(flow.u * at.to_x + flow.v * at.to_y, 0.0);
    const double speed = toward * flow.per_plan;
    return flow.density * (speed * speed) * std::min(1.0, flow.normal / kFullLoadDepth);
}

// The bending moment of a flow of this pressure, Pa, and thickness, m, on a stem, N m.
double moment_on(const Stems& stems, double pressure, double thickness) {
    return 0.5 * momentum::kStemDrag * pressure * (stems.diameter_cm / 100.0) * thickness * (0.5 * thickness);
}

// Whether the flow at a vertex breaks these stems.
bool breaks(const State& s, int x, int y, const Stems& stems) {
    // Most flows are too weak by far, and that shows without a square root: p h² ≤ ρ |v|² R², because h = R cos θ and
    // |v|ₛ ≤ |v|/cos θ. The margin is larger than any rounding.
    constexpr double kMargin = 1.001;
    const auto u = static_cast<double>(s.velocity_x(x, y)), v = static_cast<double>(s.velocity_y(x, y));
    const auto densest = static_cast<double>(s.mixture ? std::max(s.params.density, s.mixture->lower.density)
                                                       : s.params.density);
    const double moment = moment_of(stems);
    const double at_most = moment_on(stems, densest * (u * u + v * v), static_cast<double>(s.rolling(x, y)));
    if (kMargin * at_most < moment) return false;

    const Flow flow = flow_at(s, x, y);
    const double speed_squared = (flow.u * flow.u + flow.v * flow.v) * (flow.per_plan * flow.per_plan);
    return moment_on(stems, flow.density * speed_squared, flow.normal) > moment;
}

// Depth of the layers above the first surface, mm.
std::int64_t buried_at(const State& s, std::int32_t vertex) {
    const int x = vertex % s.grid.nx, y = vertex / s.grid.nx;
    const double above = (static_cast<double>(s.depth(x, y)) - static_cast<double>(s.first_depth(x, y))) +
                         static_cast<double>(s.rolling(x, y));
    return std::llrint(1000 * std::max(above, 0.0));
}

// Breaks what the flow at a vertex can break; returns whether it did.
bool break_stems(State& s, int x, int y) {
    Stems& stems = s.things->forest(x, y);
    if (s.rolling(x, y) == 0 || stems.standing == 0 || !breaks(s, x, y, stems)) return false;
    stems.lying = static_cast<std::uint16_t>(std::min(stems.lying + stems.standing, kMostStems));
    stems.standing = 0;
    rebuild_forest(s, x, y);
    return true;
}

// Returns whether any forest broke. Visits the forest of tiles that were written in this tick, row by row as it is
// listed.
bool break_forest(State& s) {
    const std::vector<std::int32_t>& wooded = s.things->wooded;
    const Tiles& tiles = s.tiles;
    bool any = false;
    auto at = wooded.begin();
    for (int y = 0; y < s.grid.ny && at != wooded.end(); ++y) {
        const std::int32_t row = y * s.grid.nx;
        const std::uint8_t* written = tiles.uncounted.data() + tiles.number(0, y / tiles.height);
        for (int column = 0; column < tiles.columns; ++column) {
            if (!written[column]) continue;
            const int x0 = column * tiles.width, x1 = std::min(x0 + tiles.width, s.grid.nx);
            if (at != wooded.end() && *at < row + x0) at = std::lower_bound(at, wooded.end(), row + x0);
            for (; at != wooded.end() && *at < row + x1; ++at) any = break_stems(s, *at - row, y) || any;
        }
    }
    return any;
}

// Returns whether an object was destroyed.
bool load_objects(State& s) {
    Things& t = *s.things;
    bool any = false;
    for (std::size_t i = 0; i < t.list.size(); ++i) {
        Thing& thing = t.list[i];
        const bool stood = !thing.destroyed();
        const bool looks_out = !thing.under(), was_whole = !thing.damaged();
        for (std::uint32_t k = 0; k < t.loaded_of[i].count; ++k) {
            const LoadedVertex& at = t.loaded[t.loaded_of[i].first + k];
            const int x = at.vertex % s.grid.nx, y = at.vertex / s.grid.nx;
            thing.buried = std::max(thing.buried, buried_at(s, at.vertex));
            if (s.rolling(x, y) > 0)
                thing.load = std::max<std::int64_t>(thing.load, std::llrint(load_of(flow_at(s, x, y), at)));
        }
        any = any || (stood && thing.destroyed());
        if (looks_out == thing.under() || was_whole == thing.damaged()) ++t.changed;
    }
    return any;
}

bool is_any_written(const Tiles& tiles) {
    const auto written = [](std::uint8_t tile) { return tile != 0; };
    return std::any_of(tiles.uncounted.begin(), tiles.uncounted.end(), written);
}

}  // namespace

void load_things(State& s) {
    if (!s.things || !is_any_written(s.tiles)) return;
    if (break_forest(s)) {
        s.things->unhashed = true;
        ++s.things->changed;
    }
    if (load_objects(s)) {
        rebuild_objects(s);
        renew_ground(s);
    }
}

}  // namespace sim
