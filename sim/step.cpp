#include "sim/step.h"

#include <algorithm>

#include "sim/bcre/plain.h"
#include "sim/engine.h"
#include "sim/ground.h"
#include "sim/load_things.h"
#include "sim/momentum/plain.h"
#include "sim/sweep/count_mass.h"
#include "sim/weather/anchor.h"
#include "sim/weather/hour.h"
#include "sim/weather/release.h"
#include "sim/world/params.h"
#include "sim/world/quanta.h"
#include "sim/world/state.h"

namespace sim {

template <class Number>
void substep(Layers<Number>& layers, const Params& params, Scratch<Number>& scratch, Workers& workers,
             Substep<Number> sub) {
    if (has_momentum(params.model))
        momentum::substep(layers, params, scratch.momentum(), scratch.context, workers, sub);
    else
        bcre::substep(layers, params, scratch.bcre(), scratch.context, workers, sub);
}

template void substep(Layers<float>&, const Params&, Scratch<float>&, Workers&, Substep<float>);
template void substep(Layers<double>&, const Params&, Scratch<double>&, Workers&, Substep<double>);

Substeps substeps_of(const State& state) {
    const Substeps upper = substeps_of(state.params, state.grid.dx);
    if (!state.mixture) return upper;
    const Substeps lower = substeps_of(state.mixture->lower, state.grid.dx);
    return lower.count > upper.count ? lower : upper;
}

namespace {

void substep_plainly(State& state, Engine& engine, const Substep<float>& sub) {
    Scratch<float>& scratch = *engine.scratch;
    Workers& workers = engine.workers;
    state.tiles.wake_all();
    scratch.context.things = state.things ? &*state.things : nullptr;
    scratch.context.weather = state.weather ? &*state.weather : nullptr;
    if (state.mixture) {
        scratch.context.lower = &state.mixture->lower;
        begin_mixing(state, *scratch.context.mixing, workers);
        engine.watch.done("begin_mixing");
    }
    substep(state, state.params, scratch, workers, sub);
    state.ledger.out += drained(scratch);
    state.limited += take_limited(scratch);
    if (state.mixture) {
        const auto [flux_x, flux_y] = scratch.fluxes();
        if (state.params.model == Model::kBcreInertial)
            mix_exchange(state, *scratch.context.mixing, scratch.momentum().exchanged, sub.dither, workers);
        finish_mixing(state, *scratch.context.mixing, flux_x, flux_y, scratch.context.outlets, sub.dither,
                      workers);
        engine.watch.done("finish_mixing");
    }
}

// A tick without flow: an hour of weather, and the slabs that let go after it. Wakes only their tiles.
void pass_hour(State& state, Engine& engine) {
    engine.watch.begin(StageWatch::kCommands);
    weather::pass_hour(state, *engine.weather, engine.workers);
    state.tiles.open_all();
    std::fill(state.tiles.unsmoothed.begin(), state.tiles.unsmoothed.end(), std::uint8_t{1});
    ++state.tick;
    if (weather::is_release_hour(state.weather->hours))
        weather::release(state, *engine.weather, engine.workers);
    engine.watch.done("weather");
    count_changed_mass(state, engine.options.instruction_set);
}

// A flow begins on ground that weather has changed.
void anchor(State& state, std::span<const Command> commands, Engine& engine) {
    if (weather::anchor(state)) {
        find_first_slope(state, state.params, 0, state.grid.nx - 1, 0, state.grid.ny - 1);
        engine.smoother->smooth(state, engine.workers);  // all tiles are marked for it
    }
    if (commands.empty()) return;
    state.weather->stirred = state.tick;
    state.weather->greatest_motion = 0;
}

// After a tick of flow: weather continues on the snow that it has changed.
void hand_over(State& state, Engine& engine) {
    if (weather::settle_creep(state)) count_changed_mass(state, engine.options.instruction_set);
    if (state.ledger.rolling == 0 && state.running_commands.empty()) weather::reconcile(state);
}

}  // namespace

void step(State& state, std::span<const Command> commands, Engine& engine) {
    if (commands.empty() && is_calm(state)) return pass_hour(state, engine);
    if (state.weather) anchor(state, commands, engine);

    // Commands come first: material poured in this tick rolls in this tick, with the parameters set for it.
    engine.watch.begin(StageWatch::kCommands);
    apply_commands(state, commands);
    renew_ground(state);
    engine.watch.done("commands");
    if (engine.smoother && state.tick % momentum::kTicksPerSmoothing == 0) {
        engine.smoother->smooth(state, engine.workers);
        engine.watch.done("smooth_ground");
    }

    const Substeps substeps = substeps_of(state);
    for (int i = 0; i < substeps.count; ++i) {
        const std::int64_t substeps_done = state.tick * substeps.count + i;
        const Substep<float> sub{substeps.dt, dither_of(substeps_done)};
        engine.watch.begin(i);
        if (engine.sweeper) {
            const sweep::Booked booked =
                engine.sweeper->substep(state, engine.workers, engine.options.instruction_set, sub);
            state.ledger.out += booked.drained;
            state.limited += booked.limited;
        } else {
            substep_plainly(state, engine, sub);
        }
    }

    // bcre's velocity follows from the layers; views need it for the current layers.
    engine.watch.begin(substeps.count);
    if (engine.sweeper) {
        engine.sweeper->find_velocity(state, engine.workers, engine.options.instruction_set);
    } else if (state.params.model == Model::kBcre) {
        bcre::find_velocity(state, state.params, engine.scratch->bcre(), engine.scratch->context,
                            engine.workers);
    }

    ++state.tick;
    load_things(state);
    count_changed_mass(state, engine.options.instruction_set);
    count_still_ticks(state);
    if (state.weather) hand_over(state, engine);
}

}  // namespace sim
