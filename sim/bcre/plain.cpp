#include "sim/bcre/plain.h"

#include "sim/bcre/stages.h"
#include "sim/stages/over_rows.h"
#include "sim/stages/plain_context.h"
#include "sim/world/layers.h"

namespace sim::bcre {

template <class Number>
StageRows<Number> stage_rows(Layers<Number>& layers, const Params& params, Fields<Field<Number>>& fields,
                             Substep<Number> sub) {
    StageRows<Number> w{rows_of(fields),
                        {layers.grid.nx, layers.grid.ny, params.borders,
                         constants_of(params, layers.grid.dx, sub), Rows<Number>(layers.bedrock)}};
    w.u0.depth = Rows<Number>(layers.depth);
    w.u0.rolling = Rows<Number>(layers.rolling);
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
    const auto find_drops_of = [&](StateRows<Number>& u) {
        over.each_row_do("fill_halo", [&](int y) { fill_halo<Number>(w, u, y, all); });
        over.each_face(
            "find_drops", [&](int y) { return find_drops<Number>(w, u, u.drop_x, u.drop_y, y); },
            [&](int y) { end_drops<Number>(w, u.drop_x, y); });
    };
    const auto close = [&](int y) { close_walls<Number>(w, w.flux_x, w.flux_y, y, all); };
    const auto end_outflows = [&](int y) { end_outflow<Number>(w, w.outflow, w.u0, y, all); };
    const auto find_motion = [&](StateRows<Number>& u) {
        over.each_face("find_curvature",
                       [&](int y) { return find_curvature<Number>(w, u, u.curvature_x, u.curvature_y, y); });
        over.each_row("find_limited_slope_dx",
                      [&](auto&, int y) { return find_limited_slope_dx<Number>(u, u.slope_dx, y); });
        over.each_row(
            "find_central_velocity",
            [&](const auto& its, int y) {
                return find_central_velocity<Number>(its, u, u.velocity_x, u.velocity_y, y);
            },
            [&](int y) { end_velocity<Number>(w, u.velocity_x, y); });
    };
    const auto find_first_order_slope = [&] {
        over.each_row("find_slope_dx",
                      [&](auto& its, int y) { return find_slope_dx<Number>(its.u0, its.u0.slope_dx, y); });
    };

    find_drops_of(w.u0);
    switch (params.scheme) {
        case Scheme::kLaxFriedrichs:
            find_first_order_slope();
            over.each_row(
                "find_quarter_outflow",
                [&](auto& its, int y) { return find_quarter_outflow<Number>(its, its.outflow, its.u0, y); },
                end_outflows);
            over.each_face(
                "find_quarter_fluxes",
                [&](int y) { return find_quarter_fluxes<Number>(w, w.flux_x, w.flux_y, y); }, close);
            over.each_row_of_bed("settle", [&](auto& its, int y) {
                return settle<Number, Scheme::kLaxFriedrichs>(its, its.u0, y, its.nx);
            });
            break;
        case Scheme::kLocalLaxFriedrichs:
            find_first_order_slope();
            over.each_row(
                "find_outflow", [&](auto& its, int y) { return find_outflow<Number>(its, its.outflow, y); },
                end_outflows);
            over.each_face("find_split_fluxes",
                           [&](int y) { return find_split_fluxes<Number>(w, w.flux_x, w.flux_y, y); });
            over.each_row_of_bed("settle", [&](auto& its, int y) {
                return settle<Number, Scheme::kLocalLaxFriedrichs>(its, its.u0, y, its.nx);
            });
            break;
        case Scheme::kMuscl:
            find_motion(w.u0);
            over.each_face(
                "find_muscl_fluxes",
                [&](int y) { return find_muscl_fluxes<Number, RkStage::kFirst>(w, w.flux_x, w.flux_y, y); },
                close);
            over.each_row_of_bed(
                "predict", [&](auto& its, int y) { return predict<Number>(its, its.exchanged, its.u1, y); },
                [&](int y) { clear_drains<Number>(w.u1, outlets, y, all); });
            find_drops_of(w.u1);
            find_motion(w.u1);
            over.each_face(
                "find_muscl_fluxes",
                [&](int y) { return find_muscl_fluxes<Number, RkStage::kSecond>(w, w.flux_x, w.flux_y, y); },
                close);
            over.each_row(
                "find_share", [&](auto& its, int y) { return find_share<Number>(its, its.share, y); },
                [&](int y) { end_share<Number>(w, w.share, y, all); });
            over.each_face("share_fluxes",
                           [&](int y) { return share_fluxes<Number>(w, w.flux_x, w.flux_y, y); });
            over.each_face("quantise_fluxes",
                           [&](int y) { return quantise_fluxes<Number>(w, w.flux_x, w.flux_y, y); });
            over.each_row_of_bed("settle", [&](auto& its, int y) {
                return settle<Number, Scheme::kMuscl>(its, its.u0, y, its.nx);
            });
            break;
    }
    over.each_row_do("clear_drains", [&](int y) { clear_drains<Number>(w.u0, outlets, y, all); });
}

void find_velocity(Layers<float>& layers, const Params& params, Fields<Field<float>>& fields,
                   const PlainContext& context, Workers& workers) {
    StageRows<float> w = stage_rows(layers, params, fields, {});
    w.u0.velocity_x = Rows<float>(layers.velocity_x);
    w.u0.velocity_y = Rows<float>(layers.velocity_y);
    const auto blends = blends_of<Constants<float>>(context, params, [&](const Params& blend) {
        return constants_of(blend, layers.grid.dx, Substep<float>{});
    });
    const OverRows<float, StageRows<float>> over(workers, w, blends, context.watch);
    over.each_row_do("fill_halo", [&](int y) { fill_halo<float>(w, w.u0, y, over.all()); });
    over.each_face("find_drops",
                   [&](int y) { return find_drops<float>(w, w.u0, w.u0.drop_x, w.u0.drop_y, y); });
    over.each_row("find_velocity", [&](auto& its, int y) {
        return find_velocity<float>(its, its.u0.velocity_x, its.u0.velocity_y, y, its.nx);
    });
}

template StageRows<float> stage_rows(Layers<float>&, const Params&, Fields<Field<float>>&, Substep<float>);
template void substep(Layers<float>&, const Params&, Fields<Field<float>>&, const PlainContext&, Workers&,
                      Substep<float>);
template void substep(Layers<double>&, const Params&, Fields<Field<double>>&, const PlainContext&, Workers&,
                      Substep<double>);

}  // namespace sim::bcre
