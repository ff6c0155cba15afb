#include "sim/step.h"

#include <utility>

#include "sim/bcre/constants.h"
#include "sim/bcre/inertial.h"
#include "sim/bcre/plain.h"
#include "sim/borders.h"
#include "sim/engine.h"
#include "sim/ledger.h"
#include "sim/params.h"
#include "sim/quanta.h"
#include "sim/state.h"

namespace sim {

namespace {

// The stages of `bcre`, one after the other (bcre/plain.h).
template <class Number>
void substep_bcre(Layers<Number>& layers, const Params& params, Scratch<Number>& scratch, Workers& workers,
                  const bcre::Constants<Number>& c) {
    const auto each_band = [&](auto&& stage) { workers.each_band(layers.grid.ny, stage); };
    const Scheme scheme = params.scheme;

    // Where down is, how fast, whither and how much is wanted, from the layers as they lie now.
    const auto find_transport = [&] {
        fill_borders(layers, params);  // the halo takes part in every stencil below
        each_band([&](int first, int last) { bcre::find_slope(layers, scratch, scheme, first, last); });
        if (scheme == Scheme::kMuscl) {
            each_band(
                [&](int first, int last) { bcre::find_central_velocity(layers, scratch, c, first, last); });
            bcre::continue_velocity(scratch);
        } else {
            each_band([&](int first, int last) { bcre::find_pace(layers, scratch, c, first, last); });
        }
        each_band([&](int first, int last) { bcre::find_gives(layers, scratch, scheme, c, first, last); });
    };
    const auto find_exchange = [&] {
        each_band([&](int first, int last) { bcre::find_exchange(layers, scratch, scheme, c, first, last); });
    };
    const auto swap_with_predicted = [&] {
        std::swap(layers.depth, scratch.depth);
        std::swap(layers.rolling, scratch.rolling);
    };

    find_transport();
    if (scheme == Scheme::kMuscl) {
        // Second order: the mean of what the layers want now and of what they would want where that leads.
        find_exchange();
        each_band([&](int first, int last) { bcre::predict(layers, scratch, first, last); });
        std::swap(scratch.given, scratch.first_given);
        std::swap(scratch.exchanged, scratch.first_exchanged);
        swap_with_predicted();
        clear_drains(layers, scratch.outlets);
        find_transport();
        find_exchange();
        swap_with_predicted();
        each_band([&](int first, int last) { bcre::take_means(scratch, first, last); });
    }

    // No more than there is to give, in whole quanta; then it is carried.
    each_band([&](int first, int last) { bcre::book_gives(layers, scratch, scheme, c, first, last); });
    each_band([&](int first, int last) { bcre::carry_gives(layers, scratch, first, last); });
    std::swap(layers.rolling, scratch.rolling);
    clear_drains(layers, scratch.outlets);

    // Between the layers, where the flow stands now.
    if (scheme != Scheme::kMuscl) find_exchange();
    each_band([&](int first, int last) { bcre::settle(layers, scratch, c, first, last); });
}

// bcre-inertial: velocity relaxes, layers move and exchange, velocity relaxes (bcre/inertial_heun.cpp).
template <class Number>
void substep_inertial(Layers<Number>& layers, const Params& params, Scratch<Number>& scratch,
                      Workers& workers, Substep<Number> sub) {
    const auto each_band = [&](auto&& stage) { workers.each_band(layers.grid.ny, stage); };
    const auto find_rates = [&](const Field<Number>& begun) {
        fill_borders(layers, params);
        each_band(
            [&](int first, int last) { bcre::inertial_exchange(layers, params, scratch, sub, first, last); });
        each_band(
            [&](int first, int last) { bcre::inertial_fluxes(layers, begun, scratch, sub, first, last); });
    };
    const auto swap_layers_with_scratch = [&] {
        std::swap(layers.depth, scratch.depth);
        std::swap(layers.rolling, scratch.rolling);
        std::swap(layers.velocity_x, scratch.velocity_x);
        std::swap(layers.velocity_y, scratch.velocity_y);
    };

    fill_borders(layers, params);
    each_band([&](int first, int last) { bcre::inertial_relax(layers, params, sub, first, last); });

    // Where what is carried and exchanged now would lead.
    find_rates(layers.rolling);
    each_band([&](int first, int last) { bcre::inertial_predict(layers, scratch, first, last); });
    std::swap(scratch.flux_x, scratch.first_flux_x);
    std::swap(scratch.flux_y, scratch.first_flux_y);
    std::swap(scratch.exchanged, scratch.first_exchanged);
    swap_layers_with_scratch();
    clear_drains(layers, scratch.outlets);

    // What would be carried and exchanged from there; the mean of both is booked, in whole quanta.
    find_rates(scratch.rolling);
    each_band([&](int first, int last) { bcre::inertial_book(scratch, sub, first, last); });
    each_band([&](int first, int last) { bcre::inertial_finish(layers, params, scratch, sub, first, last); });
    swap_layers_with_scratch();
    std::swap(scratch.flux_x, scratch.first_flux_x);  // booked, for the ledger
    std::swap(scratch.flux_y, scratch.first_flux_y);
    clear_drains(layers, scratch.outlets);

    // Last: it ends what exchange left thin.
    each_band([&](int first, int last) { bcre::inertial_yield(layers, params, scratch, first, last); });
}

}  // namespace

template <class Number>
void substep(Layers<Number>& layers, const Params& params, Scratch<Number>& scratch, Workers& workers,
             Substep<Number> sub) {
    if (params.model == Model::kBcre)
        substep_bcre(layers, params, scratch, workers, bcre::constants_of(params, layers.grid.dx, sub));
    else
        substep_inertial(layers, params, scratch, workers, sub);
}

template void substep(Layers<float>&, const Params&, Scratch<float>&, Workers&, Substep<float>);
template void substep(Layers<double>&, const Params&, Scratch<double>&, Workers&, Substep<double>);

void step(State& state, std::span<const Command> commands, Engine& engine) {
    // A person's hand first: what is poured in this tick rolls in this tick, by the numbers set for it.
    apply_commands(state, commands);

    const Substeps substeps = substeps_of(state.params, state.grid.dx);
    for (int i = 0; i < substeps.count; ++i) {
        const std::int64_t substeps_done = state.tick * substeps.count + i;
        const Substep<float> sub{substeps.dt, dither_of(substeps_done)};
        if (engine.sweeper) {
            state.ledger.out +=
                engine.sweeper->substep(state, engine.workers, engine.how.instruction_set, sub);
        } else {
            substep(state, state.params, *engine.scratch, engine.workers, sub);
            state.ledger.out += drained(*engine.scratch, state.params.model);
        }
    }

    // bcre's velocity follows from the layers; who looks on wants it where they are now.
    if (engine.sweeper) {
        engine.sweeper->find_velocity(state, engine.workers, engine.how.instruction_set);
    } else if (state.params.model == Model::kBcre) {
        const auto c = bcre::constants_of(state.params, state.grid.dx, Substep<float>{});
        fill_borders(state, state.params);
        engine.workers.each_band(state.grid.ny,
                                 [&](int first, int last) { bcre::find_velocity(state, c, first, last); });
    }

    ++state.tick;
    count_mass(state);
}

}  // namespace sim
