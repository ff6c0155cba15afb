#include "sim/engine.h"

#include "sim/state.h"

namespace sim {

Engine::Engine(State& state, const How& as) : how(as), workers(as.threads) {
    CHECK(has(how.instruction_set));
    state.tiles = Tiles(state.grid, how.tile_width, how.tile_height);
    state.tiles.may_sleep = how.tiles_may_sleep;
    how.plain = how.plain || state.params.model != Model::kBcre || state.params.scheme == Scheme::kMuscl;
    if (how.plain)
        scratch.emplace(state);
    else
        sweeper.emplace(state, how.threads);
}

}  // namespace sim
