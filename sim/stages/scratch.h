#pragma once

#include <cstdint>
#include <optional>

#include "sim/core/grid.h"
#include "sim/stages/stage_watch.h"
#include "sim/world/blend.h"
#include "sim/world/layers.h"
#include "sim/world/mixture.h"
#include "sim/world/outlets.h"
#include "sim/world/params.h"

namespace sim {

// What the stages of `bcre` write, field by field; bcre/work.h says what each is.
template <class Number>
struct LevelFields {
    Field<Number> depth, rolling;  // of what is predicted; else they are the layers'
    Field<Number> drop_x, drop_y, curvature_x, curvature_y, slope_dx, velocity_x, velocity_y;
};

// What those of `bcre-inertial` write (inertial/work.h).
template <class Number>
struct FlowFields {
    Field<Number> depth, rolling, velocity_x, velocity_y;  // of what is predicted; else they are the layers'
    Field<Number> drop_x, drop_y, curvature_x, curvature_y, exchanged;
    Field<Number> rolling_x, u_x, v_x, rolling_y, u_y, v_y;
    Field<Number> flux_x, flux_y, momentum_xu, momentum_xv, momentum_yu, momentum_yv;
};

// What a plain step needs between its stages; holds nothing from one sub-step to the next. Made once per
// world, so that a step allocates nothing.
template <class Number>
struct Scratch {
    Scratch(const Layers<Number>& layers, Model model);

    LevelFields<Number> now, then;
    Field<Number> outflow, flux_x, flux_y, exchanged, share;  // of `bcre`
    FlowFields<Number> flow_now, flow_then;
    Outlets outlets;

    // Through the faces, in the sub-step that was done last, m.
    struct Fluxes {
        Field<Number>&x, &y;
    };
    Fluxes fluxes(Model model) {
        if (model == Model::kBcre) return {flux_x, flux_y};
        return {flow_now.flux_x, flow_now.flux_y};
    }

    // Of a mixed world, set by who has its state.
    const Params* lower = nullptr;
    std::optional<Mixing> mixing;

    StageWatch* watch = nullptr;  // of who wants to know, set by the same
};

// What they carried into drains, in whole quanta.
std::int64_t drained(Scratch<float>& scratch, Model model);

// The constants of all blends, `constants_of(Params)` of each; none in a world of one material.
template <class Constants, class Number, class ConstantsOf>
std::optional<Blends<Constants>> blends_of(const Scratch<Number>& scratch, const Params& params,
                                           ConstantsOf&& constants_of) {
    if (!scratch.lower) return std::nullopt;
    Blends<Constants> blends{{}, &scratch.mixing->flow, &scratch.mixing->bed};
    for (int blend = 0; blend < kBlends; ++blend)
        blends.constants[static_cast<std::size_t>(blend)] =
            constants_of(blended(params, *scratch.lower, blend));
    return blends;
}

}  // namespace sim
