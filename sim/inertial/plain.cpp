#include "sim/inertial/plain.h"

#include "sim/inertial/stages.h"
#include "sim/stages/over_rows.h"
#include "sim/stages/scratch.h"

namespace sim::inertial {

template <class Number>
Work<Number> work_of(Layers<Number>& layers, const Params& params, Scratch<Number>& scratch,
                     Substep<Number> sub) {
    const auto rows = [](Field<Number>& field) { return Rows<Number>(field); };
    const auto level = [&](FlowFields<Number>& f, Field<Number>& depth, Field<Number>& rolling,
                           Field<Number>& u, Field<Number>& v) {
        return Level<Number>{rows(depth),
                             rows(rolling),
                             rows(u),
                             rows(v),
                             rows(f.drop_x),
                             rows(f.drop_y),
                             rows(f.curvature_x),
                             rows(f.curvature_y),
                             rows(f.exchanged),
                             rows(f.rolling_x),
                             rows(f.u_x),
                             rows(f.v_x),
                             rows(f.rolling_y),
                             rows(f.u_y),
                             rows(f.v_y),
                             rows(f.flux_x),
                             rows(f.flux_y),
                             rows(f.momentum_xu),
                             rows(f.momentum_xv),
                             rows(f.momentum_yu),
                             rows(f.momentum_yv)};
    };
    FlowFields<Number>& then = scratch.flow_then;
    return {layers.grid.nx,
            layers.grid.ny,
            params.borders,
            constants_of(params, layers.grid.dx, sub),
            rows(layers.bedrock),
            rows(layers.first_slope),
            rows(layers.first_depth),
            level(scratch.flow_now, layers.depth, layers.rolling, layers.velocity_x, layers.velocity_y),
            level(then, then.depth, then.rolling, then.velocity_x, then.velocity_y)};
}

template <class Number>
void substep(Layers<Number>& layers, const Params& params, Scratch<Number>& scratch, Workers& workers,
             Substep<Number> sub) {
    const Work<Number> world = work_of(layers, params, scratch, sub);
    const Outlets::View outlets = scratch.outlets.view();
    const auto blends = blends_of<Constants<Number>>(
        scratch, params, [&](const Params& blend) { return constants_of(blend, layers.grid.dx, sub); });
    const OverRows<Number, Work<Number>> over(workers, world, blends, scratch.watch);
    const Span all = over.all();
    // What would be exchanged and carried, as the layers lie and move.
    const auto find_rates = [&](const Level<Number>& level) {
        over.each_face(
            "find_drops", [&](int y) { return find_drops<Number>(world, level, y); },
            [&](int y) { end_drops<Number>(world, level, y); });
        over.each_face("find_bends", [&](int y) { return find_curvature<Number>(world, level, y); });
        over.each_row_of_bed("find_exchange",
                             [&](const auto& w, int y) { return find_exchange<Number>(w, level, y); });
        over.each_row(
            "find_slopes", [&](const auto&, int y) { return find_slopes<Number>(level, y); },
            [&](int y) { end_slopes<Number>(world, level, y, all); });
        over.each_face("find_fluxes_x", [&](int y) { return find_fluxes_x<Number>(world, level, y); });
        over.each_face(
            "find_fluxes_y", [&](int y) { return find_fluxes_y<Number>(world, level, y); },
            [&](int y) { end_fluxes<Number>(world, level, y, all); });
    };

    over.each_row_do("fill_halo", [&](int y) { fill_halo<Number>(world, world.now, y, all); });
    over.each_row(
        "relax", [&](const auto& w, int y) { return relax<Number>(w, w.now, y, w.nx); },
        [&](int y) { end_velocity<Number>(world, world.now, y, all); });
    find_rates(world.now);
    over.each_row(
        "predict", [&](const auto& w, int y) { return predict<Number>(w, y); },
        [&](int y) { clear_drains<Number>(world.then, outlets, y, all); });
    over.each_row_do("fill_halo", [&](int y) {
        fill_halo<Number>(world, world.then, y, all), end_velocity<Number>(world, world.then, y, all);
    });
    find_rates(world.then);
    over.each_face("book_fluxes", [&](int y) { return quantise_fluxes<Number>(world, y); });
    over.each_row(
        "finish", [&](const auto& w, int y) { return finish<Number>(w, y, w.nx); },
        [&](int y) { clear_drains<Number>(world.now, outlets, y, all); });
    over.each_row("relax", [&](const auto& w, int y) { return relax<Number>(w, w.then, y, w.nx); });
    over.each_row_of_bed("yield", [&](const auto& w, int y) { return yield<Number>(w, y, w.nx); });
}

template Work<float> work_of(Layers<float>&, const Params&, Scratch<float>&, Substep<float>);
template void substep(Layers<float>&, const Params&, Scratch<float>&, Workers&, Substep<float>);
template void substep(Layers<double>&, const Params&, Scratch<double>&, Workers&, Substep<double>);

}  // namespace sim::inertial
