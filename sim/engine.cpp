#include "sim/engine.h"

#include "sim/world/state.h"

namespace sim {

Engine::Engine(State& state, const StepOptions& as) : options(as), workers(as.threads) {
    CHECK(has(options.instruction_set));
    state.tiles = Tiles(state.grid, options.tile_width, options.tile_height);
    state.tiles.may_sleep = options.tiles_may_sleep;
    if (options.plain || state.mixture) {  // the sweep knows one material
        scratch.emplace(state, state.params.model);
        scratch->context.watch = &watch;
        if (state.mixture) scratch->context.mixing.emplace(state);
    } else {
        sweeper.emplace(state, options.threads, options.last_tile_first);
    }
    if (has_momentum(state.params.model))
        smoother.emplace(state.grid, options.tile_width, options.tile_height, options.threads);
    if (state.weather) weather.emplace(state, options.threads);
}

}  // namespace sim
