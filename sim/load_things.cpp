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

bool breaks(const Flow& flow, const Stems& stems) {
    const double speed_squared = (flow.u * flow.u + flow.v * flow.v) * (flow.per_plan * flow.per_plan);
    const double moment = 0.5 * momentum::kStemDrag * (flow.density * speed_squared) *
                          (stems.diameter_cm / 100.0) * flow.normal * (0.5 * flow.normal);
    return moment > moment_of(stems);
}

// Depth of the layers above the first surface, mm.
std::int64_t buried_at(const State& s, std::int32_t vertex) {
    const int x = vertex % s.grid.nx, y = vertex / s.grid.nx;
    const double above = (static_cast<double>(s.depth(x, y)) - static_cast<double>(s.first_depth(x, y))) +
                         static_cast<double>(s.rolling(x, y));
    return std::llrint(1000 * std::max(above, 0.0));
}

// Returns whether any forest broke.
bool break_forest(State& s) {
    Things& t = *s.things;
    bool any = false;
    for (const std::int32_t vertex : t.wooded) {
        const int x = vertex % s.grid.nx, y = vertex / s.grid.nx;
        if (s.rolling(x, y) == 0) continue;
        Stems& stems = t.forest(x, y);
        if (!breaks(flow_at(s, x, y), stems)) continue;
        stems.lying = static_cast<std::uint16_t>(std::min(stems.lying + stems.standing, kMostStems));
        stems.standing = 0;
        rebuild_forest(s, x, y);
        any = true;
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

}  // namespace

void load_things(State& s) {
    if (!s.things) return;
    if (break_forest(s)) {
        rebuild_wooded(*s.things);
        s.things->unhashed = true;
        ++s.things->changed;
    }
    if (load_objects(s)) {
        rebuild_objects(s);
        renew_ground(s);
    }
}

}  // namespace sim
