#include "sim/bcre/plain.h"

#include "sim/bcre/stages.h"
#include "sim/stages/over_rows.h"
#include "sim/stages/scratch.h"

namespace sim::bcre {
namespace {

template <class Number>
Level<Number> level_of(LevelFields<Number>& f, Field<Number>& depth, Field<Number>& rolling) {
    const auto rows = [](Field<Number>& field) { return Rows<Number>(field); };
    return {rows(depth),         rows(rolling),    rows(f.drop_x),     rows(f.drop_y),    rows(f.curvature_x),
            rows(f.curvature_y), rows(f.slope_dx), rows(f.velocity_x), rows(f.velocity_y)};
}

}  // namespace

template <class Number>
Work<Number> work_of(Layers<Number>& layers, const Params& params, Scratch<Number>& scratch,
                     Substep<Number> sub) {
    return {layers.grid.nx,
            layers.grid.ny,
            params.borders,
            constants_of(params, layers.grid.dx, sub),
            Rows<Number>(layers.bedrock),
            level_of(scratch.now, layers.depth, layers.rolling),
            level_of(scratch.then, scratch.then.depth, scratch.then.rolling),
            Rows<Number>(scratch.outflow),
            Rows<Number>(scratch.flux_x),
            Rows<Number>(scratch.flux_y),
            Rows<Number>(scratch.exchanged),
            Rows<Number>(scratch.share)};
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
    const auto find_drops_of = [&](const Level<Number>& level) {
        over.each_row_do("fill_halo", [&](int y) { fill_halo<Number>(world, level, y, all); });
        over.each_face(
            "find_drops", [&](int y) { return find_drops<Number>(world, level, y); },
            [&](int y) { end_drops<Number>(world, level, y); });
    };
    const auto close = [&](int y) { close_walls<Number>(world, y, all); };
    const auto end_gift = [&](int y) { end_outflow<Number>(world, y, all); };
    const auto find_motion = [&](const Level<Number>& level) {
        over.each_face("find_bends", [&](int y) { return find_curvature<Number>(world, level, y); });
        over.each_row("find_bent_fall",
                      [&](const auto&, int y) { return find_limited_slope_dx<Number>(level, y); });
        over.each_row(
            "find_central_velocity",
            [&](const auto& w, int y) { return find_central_velocity<Number>(w, level, y); },
            [&](int y) { end_velocity<Number>(world, level, y); });
    };

    find_drops_of(world.now);
    switch (params.scheme) {
        case Scheme::kLaxFriedrichs:
            over.each_row("find_fall", [&](const auto& w, int y) { return find_slope_dx<Number>(w.now, y); });
            over.each_row(
                "find_quarters", [&](const auto& w, int y) { return find_quarter_outflow<Number>(w, y); },
                end_gift);
            over.each_face(
                "find_quarter_fluxes", [&](int y) { return find_quarter_fluxes<Number>(world, y); }, close);
            over.each_row_of_bed("settle", [&](const auto& w, int y) {
                return settle<Number, Scheme::kLaxFriedrichs>(w, y, w.nx);
            });
            break;
        case Scheme::kLocalLaxFriedrichs:
            over.each_row("find_fall", [&](const auto& w, int y) { return find_slope_dx<Number>(w.now, y); });
            over.each_row(
                "find_given", [&](const auto& w, int y) { return find_outflow<Number>(w, y); }, end_gift);
            over.each_face("find_split_fluxes", [&](int y) { return find_split_fluxes<Number>(world, y); });
            over.each_row_of_bed("settle", [&](const auto& w, int y) {
                return settle<Number, Scheme::kLocalLaxFriedrichs>(w, y, w.nx);
            });
            break;
        case Scheme::kMuscl:
            find_motion(world.now);
            over.each_face(
                "find_muscl_fluxes",
                [&](int y) { return find_muscl_fluxes<Number, RkStage::kFirst>(world, y); }, close);
            over.each_row_of_bed(
                "predict", [&](const auto& w, int y) { return predict<Number>(w, y); },
                [&](int y) { clear_drains<Number>(world.then, outlets, y, all); });
            find_drops_of(world.then);
            find_motion(world.then);
            over.each_face(
                "find_muscl_fluxes",
                [&](int y) { return find_muscl_fluxes<Number, RkStage::kSecond>(world, y); }, close);
            over.each_row(
                "find_share", [&](const auto& w, int y) { return find_share<Number>(w, y); },
                [&](int y) { end_share<Number>(world, y, all); });
            over.each_face("share_fluxes", [&](int y) { return share_fluxes<Number>(world, y); });
            over.each_face("book_fluxes", [&](int y) { return quantise_fluxes<Number>(world, y); });
            over.each_row_of_bed(
                "settle", [&](const auto& w, int y) { return settle<Number, Scheme::kMuscl>(w, y, w.nx); });
            break;
    }
    over.each_row_do("clear_drains", [&](int y) { clear_drains<Number>(world.now, outlets, y, all); });
}

void find_velocity(Layers<float>& layers, const Params& params, Scratch<float>& scratch, Workers& workers) {
    Work<float> world = work_of(layers, params, scratch, {});
    world.now.velocity_x = Rows<float>(layers.velocity_x),
    world.now.velocity_y = Rows<float>(layers.velocity_y);
    const auto blends = blends_of<Constants<float>>(scratch, params, [&](const Params& blend) {
        return constants_of(blend, layers.grid.dx, Substep<float>{});
    });
    const OverRows<float, Work<float>> over(workers, world, blends, scratch.watch);
    over.each_row_do("fill_halo", [&](int y) { fill_halo<float>(world, world.now, y, over.all()); });
    over.each_face("find_drops", [&](int y) { return find_drops<float>(world, world.now, y); });
    over.each_row("find_velocity", [&](const auto& w, int y) { return find_velocity<float>(w, y, w.nx); });
}

template Work<float> work_of(Layers<float>&, const Params&, Scratch<float>&, Substep<float>);
template void substep(Layers<float>&, const Params&, Scratch<float>&, Workers&, Substep<float>);
template void substep(Layers<double>&, const Params&, Scratch<double>&, Workers&, Substep<double>);

}  // namespace sim::bcre
