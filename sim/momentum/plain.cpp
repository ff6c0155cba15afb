#include "sim/momentum/plain.h"

#include "sim/momentum/stages.h"
#include "sim/stages/over_rows.h"
#include "sim/stages/plain_context.h"
#include "sim/world/layers.h"
#include "sim/world/things.h"
#include "sim/world/weather.h"

namespace sim::momentum {

template <class Number>
StageRows<Number> stage_rows(Layers<Number>& layers, const Params& params, Fields<Field<Number>>& fields,
                             Substep<Number> sub) {
    return {rows_of(fields),
            {layers.grid.nx, layers.grid.ny, params.borders, constants_of(params, layers.grid.dx, sub),
             Rows<Number>(layers.bedrock)},
            {Rows<Number>(layers.depth), Rows<Number>(layers.rolling), Rows<Number>(layers.velocity_x),
             Rows<Number>(layers.velocity_y)},
            Rows<Number>(layers.smooth_depth),
            Rows<Number>(layers.first_slope),
            Rows<Number>(layers.first_depth),
            {}};
}

namespace {

ThingRows<float> thing_rows(Things& t, Weather* weather) {
    return {Rows<float>(t.natural),
            Rows<float>(t.drag),
            Rows<float>(t.detrain),
            Rows<float>(t.hold),
            Rows<float>(t.net_depth),
            Rows<float>(t.wall_x),
            Rows<float>(t.wall_y),
            Rows<float>(t.water),
            weather ? Rows<float>(weather->base) : Rows<float>(t.no_floor.row(0), 0)};
}

template <class Number, bool has_things>
void all_stages(Layers<Number>& layers, const Params& params, Fields<Field<Number>>& fields,
                const PlainContext& context, Workers& workers, Substep<Number> sub) {
    StageRows<Number> w = stage_rows(layers, params, fields, sub);
    if constexpr (has_things) w.things = thing_rows(*context.things, context.weather);
    const bool exchanges = params.model == Model::kBcreInertial;
    if (!exchanges) w.exchange_nothing();
    const Outlets::View outlets = context.outlets.view();
    const auto blends = blends_of<Constants<Number>>(
        context, params, [&](const Params& blend) { return constants_of(blend, layers.grid.dx, sub); });
    const OverRows<Number, StageRows<Number>> over(workers, w, blends, context.watch);
    const Span all = over.all();
    // A row ends with the halo beside it; the first and the last also with the row beyond.
    const auto with_beyond = [&](auto&& end) {
        return [&w, end](int y) {
            end(y);
            if (y == 0) end(-1);
            if (y == w.ny - 1) end(w.ny);
        };
    };

    over.each_row_do("fill_halo", [&](int y) { fill_halo<Number>(w, w.u0, y, all); });
    over.each_row(
        "find_ground", [&](auto& its, int y) { return find_ground<Number, has_things>(its, w, y); },
        with_beyond([&](int y) { end_ground<Number>(w, w, y, all); }));
    if (exchanges) {
        over.each_row("drive", [&](auto& its, int y) { return drive<Number, true, has_things>(its, w, y); });
        over.each_row_of_bed(
            "exchange", [&](auto& its, int y) { return exchange<Number, has_things>(its, w, y); },
            [&](int y) { end_drive<Number>(w, w, y, all), end_exchange<Number>(w, w, y, all); });
    } else {
        over.each_row(
            "drive", [&](auto& its, int y) { return drive<Number, false, has_things>(its, w, y); },
            [&](int y) { end_drive<Number>(w, w, y, all); });
    }
    over.each_row(
        "reconstruct", [&](auto& its, int y) { return reconstruct<Number>(its, w, y); },
        with_beyond([&](int y) { end_reconstruct<Number>(w, w, y, all); }));
    over.each_face("find_fluxes_x", [&](int y) { return find_fluxes_x<Number, has_things>(w, w, y); });
    over.each_face(
        "find_fluxes_y", [&](int y) { return find_fluxes_y<Number, has_things>(w, w, y); },
        [&](int y) { end_fluxes<Number>(w, w, y, all); });
    over.each_row(
        "find_share", [&](auto& its, int y) { return find_share<Number>(its, w.share, y); },
        with_beyond([&](int y) { end_share<Number>(w, w.share, y, all); }));
    over.each_face("share_fluxes", [&](int y) { return share_fluxes<Number>(w, w, y); });
    over.each_face("quantise_fluxes", [&](int y) { return quantise_fluxes<Number>(w, w, y); });
    over.each_row(
        "finish",
        [&](auto& its, int y) {
            std::int64_t* limited = context.limited_in_row ? context.limited_in_row + y : nullptr;
            return finish<Number>(its, w, y, its.nx, limited);
        },
        [&](int y) {
            end_finish<Number>(w, w, y, all);
            if (!exchanges) clear_drains<Number>(w.u0, outlets, y, all);
        });
    if (!exchanges) return;
    over.each_row_of_bed(
        "find_quiet", [&](auto& its, int y) { return find_quiet<Number>(its, w, y); },
        [&](int y) {
            LayerRows<Number> moved = w.moved();
            clear_drains<Number>(moved, outlets, y, all);
            fill_halo<Number>(w, moved, y, all);
        });
    for (int y = -1; y <= w.ny; ++y) end_quiet<Number>(w, w, y, all);
    over.each_row_of_bed(
        "yield", [&](auto& its, int y) { return yield<Number, has_things>(its, its.u0, y, its.nx); },
        [&](int y) { clear_drains<Number>(w.u0, outlets, y, all); });
}

}  // namespace

template <class Number>
void substep(Layers<Number>& layers, const Params& params, Fields<Field<Number>>& fields,
             const PlainContext& context, Workers& workers, Substep<Number> sub) {
    if constexpr (kHasQuanta<Number>)
        if (context.things) return all_stages<Number, true>(layers, params, fields, context, workers, sub);
    all_stages<Number, false>(layers, params, fields, context, workers, sub);
}

template StageRows<float> stage_rows(Layers<float>&, const Params&, Fields<Field<float>>&, Substep<float>);
template void substep(Layers<float>&, const Params&, Fields<Field<float>>&, const PlainContext&, Workers&,
                      Substep<float>);
template void substep(Layers<double>&, const Params&, Fields<Field<double>>&, const PlainContext&, Workers&,
                      Substep<double>);

}  // namespace sim::momentum
