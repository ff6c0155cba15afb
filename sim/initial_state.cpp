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

void place(State& s, const InitialState::Standing& standing) {
    Things& t = things_of(s);
    if (!standing.forest.empty()) {
        CHECK(standing.forest.size() == s.grid.size());
        for (int y = 0; y < s.grid.ny; ++y)
            for (int x = 0; x < s.grid.nx; ++x) {
                t.forest(x, y) =
                    standing.forest[static_cast<std::size_t>(y) * static_cast<std::size_t>(s.grid.nx) +
                                    static_cast<std::size_t>(x)];
                rebuild_forest(s, x, y);
            }
        rebuild_wooded(t);
    }
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
    s.seed = world.seed;
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
        s.mixture = make_mixture(s, world.lower->params, world.lower->depth);
        s.mixture->lower.density = world.lower_density;
    }
    enclose(s, params);
    if (!world.standing.empty()) place(s, world.standing);
    count_mass(s);
    s.ledger.initial = s.ledger.standing + s.ledger.rolling;
    if (s.mixture) s.mixture->ledger.initial = s.mixture->ledger.standing;
    return s;
}

template void enclose(Layers<float>&, const Params&);
template void enclose(Layers<double>&, const Params&);

}  // namespace sim
