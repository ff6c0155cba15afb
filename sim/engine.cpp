#include "sim/engine.h"

#include "sim/world/state.h"

namespace sim {

Engine::Engine(State& state, const How& as) : how(as), workers(as.threads) {
    CHECK(has(how.instruction_set));
    state.tiles = Tiles(state.grid, how.tile_width, how.tile_height);
    state.tiles.may_sleep = how.tiles_may_sleep;
    if (how.plain || state.mixture) {  // the sweep knows one material
        scratch.emplace(state, state.params.model);
        scratch->watch = &watch;
        if (state.mixture) scratch->mixing.emplace(state);
    } else {
        sweeper.emplace(state, how.threads, how.last_tile_first);
    }
}

}  // namespace sim
