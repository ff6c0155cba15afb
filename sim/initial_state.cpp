#include "sim/initial_state.h"

#include <cmath>

#include "sim/ground.h"
#include "sim/momentum/smooth_ground.h"
#include "sim/sweep/count_mass.h"
#include "sim/world/quanta.h"

namespace sim {
template <class Number>
void enclose(Layers<Number>& s, const Params& params) {
    continue_bedrock(s, params);
    find_first_slope(s, params, 0, s.grid.nx - 1, 0, s.grid.ny - 1);
    s.first_depth = s.depth;
    if (has_momentum(params.model)) momentum::GroundSmoother::smooth_all(s);
}

namespace {

// Visits the values of a field without a halo.
template <class Value, class Visit>
void each_vertex(const Grid& grid, std::span<const Value> values, Visit&& visit) {
    CHECK(values.size() == grid.size());
    std::size_t i = 0;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) visit(x, y, values[i++]);
}

void place(State& s, const InitialState::Standing& standing) {
    Things& t = things_of(s);
    if (!standing.earth.empty()) {
        each_vertex(s.grid, standing.earth, [&](int x, int y, float earth) {
            t.earth(x, y) = earth;
            if (earth != 0) set_bedrock(s, x, y);
        });
        t.earth_moved = moved_in(t.earth);
    }
    if (!standing.forest.empty()) {
        each_vertex(s.grid, standing.forest, [&](int x, int y, const Stems& stems) {
            t.forest(x, y) = stems;
            rebuild_forest(s, x, y);
        });
        rebuild_wooded(t);
    }
    if (!standing.water.empty())
        each_vertex(s.grid, standing.water, [&](int x, int y, float m) { t.water(x, y) = m; });
    if (standing.earth_budget >= 0)
        t.budget = std::llrint(standing.earth_budget / s.grid.cell_area() / static_cast<double>(kQuantum));
    apply_commands(s, standing.placed);
    renew_ground(s);
}

}  // namespace

State make_state(const InitialState& world, const Params& params) {
    const Grid& grid = world.grid;
    CHECK(world.bedrock.size() == grid.size() && world.depth.size() == grid.size());
    CHECK(world.rolling.size() == grid.size() && world.has_data.size() == grid.size());

    State s;
    static_cast<Layers<float>&>(s) = make_layers<float>(grid, params, world.has_data);
    s.params = params;
    s.params.density = world.density;
    s.datum = world.datum;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) {
            const std::size_t i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(x);
            s.bedrock(x, y) = world.bedrock[i];
            if (s.site(x, y) != Site::kGround) continue;
            s.depth(x, y) = nearest_quanta(world.depth[i]);
            s.rolling(x, y) = nearest_quanta(world.rolling[i]);
        }
    if (world.lower) {
        const InitialState::Lower& lower = *world.lower;
        s.mixture = make_mixture(s, lower.params, {lower.depth, lower.settled, lower.rolling});
        s.mixture->lower.density = world.lower_density;
    }
    enclose(s, params);
    if (!world.standing.empty()) place(s, world.standing);
    if (world.weather) {
        CHECK(!fault_of(*world.weather, s.params, double{world.density}, world.lower.has_value()));
        things_of(s);  // stages read the weak layer beside what stands
        s.weather.emplace(*world.weather, s.depth);
    }
    count_mass(s);
    s.ledger.initial = s.ledger.standing + s.ledger.rolling;
    if (s.mixture) s.mixture->ledger.initial = s.mixture->ledger.standing + s.mixture->ledger.rolling;
    return s;
}

template void enclose(Layers<float>&, const Params&);
template void enclose(Layers<double>&, const Params&);

}  // namespace sim
