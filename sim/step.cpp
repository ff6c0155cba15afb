#include "sim/step.h"

#include <utility>

#include "sim/bcre/inertial.h"
#include "sim/bcre/stages.h"
#include "sim/borders.h"
#include "sim/ledger.h"
#include "sim/params.h"
#include "sim/quanta.h"
#include "sim/scratch.h"
#include "sim/state.h"
#include "sim/workers.h"

namespace sim {

namespace {

// Second order: what is carried and exchanged is the mean of what the layers ask for now and of what they
// would ask for where that leads (bcre/runge_kutta.cpp). Leaves them in `scratch`.
template <class Number>
void find_mean_rates(Layers<Number>& layers, const Params& params, Scratch<Number>& scratch, Workers& workers,
                     Substep<Number> sub) {
    const auto each_band = [&](auto&& stage) { workers.each_band(layers.grid.ny, stage); };
    const auto find_rates = [&] {
        fill_borders(layers, params);
        each_band([&](int first, int last) { bcre::slope_velocity(layers, params, first, last); });
        fill_borders(layers, params);  // walls mirror the new velocity
        each_band([&](int first, int last) { bcre::fluxes_minmod(layers, scratch, sub, first, last); });
        each_band([&](int first, int last) { bcre::limited_lower_slope(layers, scratch, first, last); });
        each_band(
            [&](int first, int last) { bcre::exchange_at_rate(layers, params, scratch, sub, first, last); });
    };
    const auto swap_with_predicted = [&] {
        std::swap(layers.depth, scratch.depth);
        std::swap(layers.rolling, scratch.rolling);
    };

    find_rates();
    each_band([&](int first, int last) { bcre::predict(layers, scratch, first, last); });
    std::swap(scratch.flux_x, scratch.first_flux_x);
    std::swap(scratch.flux_y, scratch.first_flux_y);
    std::swap(scratch.exchanged, scratch.first_exchanged);

    swap_with_predicted();
    clear_drains(layers, scratch);
    find_rates();
    swap_with_predicted();
    each_band([&](int first, int last) { bcre::mean_rates(scratch, first, last); });
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
    clear_drains(layers, scratch);

    // What would be carried and exchanged from there; the mean of both is booked, in whole quanta.
    find_rates(scratch.rolling);
    each_band([&](int first, int last) { bcre::inertial_book(scratch, sub, first, last); });
    each_band([&](int first, int last) { bcre::inertial_finish(layers, params, scratch, sub, first, last); });
    swap_layers_with_scratch();
    std::swap(scratch.flux_x, scratch.first_flux_x);  // booked, for the ledger
    std::swap(scratch.flux_y, scratch.first_flux_y);
    clear_drains(layers, scratch);

    // Last: it ends what exchange left thin.
    each_band([&](int first, int last) { bcre::inertial_yield(layers, params, scratch, first, last); });
}

}  // namespace

template <class Number>
void substep(Layers<Number>& layers, const Params& params, Scratch<Number>& scratch, Workers& workers,
             Substep<Number> sub) {
    const auto each_band = [&](auto&& stage) { workers.each_band(layers.grid.ny, stage); };
    if (params.model == Model::kBcreInertial) return substep_inertial(layers, params, scratch, workers, sub);
    const bool second_order = params.scheme == Scheme::kMuscl;

    if (second_order) {
        find_mean_rates(layers, params, scratch, workers, sub);
        fill_borders(layers, params);  // of the layers before the prediction
    } else {
        // The halo takes part in every stencil below.
        fill_borders(layers, params);

        // How fast: from the surface as it lies now.
        each_band([&](int first, int last) { bcre::slope_velocity(layers, params, first, last); });
        fill_borders(layers, params);  // walls mirror the new velocity

        // Whither and how much is wanted.
        each_band([&](int first, int last) {
            if (params.scheme == Scheme::kLaxFriedrichs)
                bcre::fluxes_lax_friedrichs(layers, scratch, sub, first, last);
            else
                bcre::fluxes_local_lax_friedrichs(layers, scratch, sub, first, last);
        });
    }

    // No more than there is to give, in whole quanta; then it is carried.
    each_band([&](int first, int last) { bcre::limit_outflow(layers, scratch, first, last); });
    each_band([&](int first, int last) { bcre::round_fluxes(layers, scratch, sub, first, last); });
    each_band([&](int first, int last) { bcre::carry(layers, scratch, first, last); });
    std::swap(layers.rolling, scratch.rolling);
    std::swap(layers.velocity_x, scratch.velocity_x);
    std::swap(layers.velocity_y, scratch.velocity_y);
    clear_drains(layers, scratch);

    // Between the layers, where the flow stands now. One slope serves both stages, so that their order
    // within a vertex does not depend on its neighbours'.
    each_band([&](int first, int last) {
        if (second_order)
            bcre::limited_lower_slope(layers, scratch, first, last);
        else
            bcre::lower_slope(layers, scratch, first, last);
    });
    each_band([&](int first, int last) {
        if (second_order)
            bcre::exchange_booked(layers, scratch, sub, first, last);
        else
            bcre::exchange(layers, params, scratch, sub, first, last);
        bcre::yield(layers, params, scratch, first, last);  // last: it ends what exchange left thin
    });
}

template void substep(Layers<float>&, const Params&, Scratch<float>&, Workers&, Substep<float>);
template void substep(Layers<double>&, const Params&, Scratch<double>&, Workers&, Substep<double>);

void step(State& state, std::span<const Command> commands, Scratch<float>& scratch, Workers& workers) {
    // A person's hand first: what is poured in this tick rolls in this tick, by the numbers set for it.
    apply_commands(state, commands);

    const Substeps substeps = substeps_of(state.params, state.grid.dx);
    for (int i = 0; i < substeps.count; ++i) {
        const std::int64_t substeps_done = state.tick * substeps.count + i;
        substep(state, state.params, scratch, workers, {substeps.dt, dither_of(substeps_done)});
        state.ledger.out += drained(scratch);
    }

    ++state.tick;
    count_mass(state);
}

}  // namespace sim
