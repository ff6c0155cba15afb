#include "sim/inertial/plain.h"

#include "sim/inertial/stages.h"
#include "sim/stages/over_rows.h"
#include "sim/stages/plain_context.h"
#include "sim/world/layers.h"

namespace sim::inertial {

template <class Number>
StageRows<Number> stage_rows(Layers<Number>& layers, const Params& params, Fields<Field<Number>>& fields,
                             Substep<Number> sub) {
    StageRows<Number> w{rows_of(fields),
                        {layers.grid.nx, layers.grid.ny, params.borders,
                         constants_of(params, layers.grid.dx, sub), Rows<Number>(layers.bedrock)},
                        Rows<Number>(layers.first_slope),
                        Rows<Number>(layers.first_depth)};
    w.u0.depth = Rows<Number>(layers.depth);
    w.u0.rolling = Rows<Number>(layers.rolling);
    w.u0.velocity_x = Rows<Number>(layers.velocity_x);
    w.u0.velocity_y = Rows<Number>(layers.velocity_y);
    return w;
}

template <class Number>
void substep(Layers<Number>& layers, const Params& params, Fields<Field<Number>>& fields,
             const PlainContext& context, Workers& workers, Substep<Number> sub) {
    StageRows<Number> w = stage_rows(layers, params, fields, sub);
    const Outlets::View outlets = context.outlets.view();
    const auto blends = blends_of<Constants<Number>>(
        context, params, [&](const Params& blend) { return constants_of(blend, layers.grid.dx, sub); });
    const OverRows<Number, StageRows<Number>> over(workers, w, blends, context.watch);
    const Span all = over.all();
    // Finds exchange and transport of a state.
    const auto find_rates = [&](StateRows<Number>& u) {
        over.each_face(
            "find_drops", [&](int y) { return find_drops<Number>(w, u, u.drop_x, u.drop_y, y); },
            [&](int y) { end_drops<Number>(w, u.drop_x, y); });
        over.each_face("find_curvature",
                       [&](int y) { return find_curvature<Number>(w, u, u.curvature_x, u.curvature_y, y); });
        over.each_row_of_bed("find_exchange",
                             [&](auto& its, int y) { return find_exchange<Number>(its, u, u.exchanged, y); });
        over.each_row(
            "find_slopes", [&](auto&, int y) { return find_slopes<Number>(u, u, y); },
            [&](int y) { end_slopes<Number>(w, u, y, all); });
        over.each_face("find_fluxes_x", [&](int y) { return find_fluxes_x<Number>(w, u, u, y); });
        over.each_face(
            "find_fluxes_y", [&](int y) { return find_fluxes_y<Number>(w, u, u, y); },
            [&](int y) { end_fluxes<Number>(w, u, y, all); });
    };

    over.each_row_do("fill_halo", [&](int y) { fill_halo<Number>(w, w.u0, y, all); });
    over.each_row(
        "relax", [&](auto& its, int y) { return relax<Number>(its, its.u0, its.u0, y, its.nx); },
        [&](int y) { end_velocity<Number>(w, w.u0, y, all); });
    find_rates(w.u0);
    over.each_row(
        "predict", [&](auto& its, int y) { return predict<Number>(its, its.u0, its.u1, y); },
        [&](int y) { clear_drains<Number>(w.u1, outlets, y, all); });
    over.each_row_do("fill_halo", [&](int y) {
        fill_halo<Number>(w, w.u1, y, all), end_velocity<Number>(w, w.u1, y, all);
    });
    find_rates(w.u1);
    over.each_face("quantise_fluxes", [&](int y) { return quantise_fluxes<Number>(w, w.u0, y); });
    over.each_row(
        "finish", [&](auto& its, int y) { return finish<Number>(its, its.u0, y, its.nx); },
        [&](int y) { clear_drains<Number>(w.u0, outlets, y, all); });
    over.each_row("relax", [&](auto& its, int y) { return relax<Number>(its, its.u1, its.u0, y, its.nx); });
    over.each_row_of_bed("yield", [&](auto& its, int y) { return yield<Number>(its, its.u0, y, its.nx); });
}

template StageRows<float> stage_rows(Layers<float>&, const Params&, Fields<Field<float>>&, Substep<float>);
template void substep(Layers<float>&, const Params&, Fields<Field<float>>&, const PlainContext&, Workers&,
                      Substep<float>);
template void substep(Layers<double>&, const Params&, Fields<Field<double>>&, const PlainContext&, Workers&,
                      Substep<double>);

}  // namespace sim::inertial
