#include "sim/step.h"

#include <utility>

#include "sim/bcre/stages.h"
#include "sim/borders.h"
#include "sim/ledger.h"
#include "sim/params.h"
#include "sim/quanta.h"
#include "sim/scratch.h"
#include "sim/state.h"
#include "sim/workers.h"

namespace sim {

void step(State& state, std::span<const Command> commands, Scratch& scratch, Workers& workers) {
    const auto each_band = [&](auto&& stage) { workers.each_band(state.grid.ny, stage); };

    // A person's hand first: what is poured in this tick rolls in this tick, by the numbers set for it.
    apply_commands(state, commands);

    const Params& params = state.params;
    const bool inertial = params.model == Model::kBcreInertial;
    const Substeps substeps = substeps_of(params, state.grid.dx);
    for (int i = 0; i < substeps.count; ++i) {
        const Substep sub{substeps.dt, dither_of(state.tick * substeps.count + i)};

        // The halo takes part in every stencil below.
        fill_borders(state, params);

        // How fast: from the surface as it lies now.
        each_band([&](int first, int last) {
            if (inertial)
                bcre::accelerate(state, params, sub, first, last);
            else
                bcre::slope_velocity(state, params, first, last);
        });
        fill_borders(state, params);  // walls mirror the new velocity

        // Whither and how much: wanted, then what there is to give, then whole quanta.
        each_band([&](int first, int last) {
            if (inertial)
                bcre::fluxes_minmod(state, scratch, sub, first, last);
            else if (params.scheme == Scheme::kLaxFriedrichs)
                bcre::fluxes_lax_friedrichs(state, scratch, sub, first, last);
            else
                bcre::fluxes_local_lax_friedrichs(state, scratch, sub, first, last);
        });
        each_band([&](int first, int last) { bcre::limit_outflow(state, scratch, first, last); });
        each_band([&](int first, int last) { bcre::round_fluxes(state, scratch, sub, first, last); });
        each_band([&](int first, int last) { bcre::carry(state, scratch, first, last); });
        std::swap(state.rolling, scratch.rolling);
        std::swap(state.velocity_x, scratch.velocity_x);
        std::swap(state.velocity_y, scratch.velocity_y);
        drain(state, scratch);

        // Between the layers, where the flow stands now. One slope serves both stages, so that their order
        // within a vertex does not depend on its neighbours'.
        each_band([&](int first, int last) { bcre::lower_slope(state, scratch, first, last); });
        each_band([&](int first, int last) {
            if (inertial)
                bcre::exchange_inertial(state, params, scratch, sub, first, last);
            else
                bcre::exchange(state, params, scratch, sub, first, last);
            bcre::yield(state, params, scratch, first, last);  // last: it ends what exchange left thin
        });
    }

    ++state.tick;
    count_mass(state);
}

}  // namespace sim
