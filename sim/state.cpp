#include "sim/state.h"

#include "sim/params.h"
#include "sim/quanta.h"

namespace sim {

State make_state(const World& world, const Params& params) {
    const Grid& grid = world.grid;
    CHECK(world.bedrock.size() == grid.size() && world.depth.size() == grid.size());
    CHECK(world.rolling.size() == grid.size() && world.has_data.size() == grid.size());

    State s;
    static_cast<Layers<float>&>(s) = make_layers<float>(grid, params, world.has_data);
    s.params = params;
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
    if (world.lower) s.mixture = make_mixture(s, world.lower->params, world.lower->depth);
    enclose(s, params);
    count_mass(s);
    s.ledger.initial = s.ledger.standing + s.ledger.rolling;
    if (s.mixture) s.mixture->ledger.initial = s.mixture->ledger.standing;
    return s;
}

bool at_rest(const State& state) {
    return state.ledger.rolling == 0 && state.sources.empty();
}

}  // namespace sim
