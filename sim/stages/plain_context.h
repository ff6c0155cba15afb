#pragma once

#include <cstdint>
#include <optional>

#include "sim/stages/stage_watch.h"
#include "sim/world/blend.h"
#include "sim/world/mixture.h"
#include "sim/world/outlets.h"
#include "sim/world/params.h"

namespace sim {

struct Things;
struct Weather;

// What the plain step of either model needs besides fields.
struct PlainContext {
    Outlets outlets;

    // Of a world of two materials; the owner of the state sets them.
    const Params* lower = nullptr;
    std::optional<Mixing> mixing = std::nullopt;

    // Of a world that has any; the owner of the state sets them.
    Things* things = nullptr;
    Weather* weather = nullptr;

    // voellmy: counts limited vertices, one number for each row.
    std::int64_t* limited_in_row = nullptr;

    StageWatch* watch = nullptr;  // none: no stage is reported
};

// The constants of all blends, `constants_of(Params)` of each; none in a world of one material.
template <class Constants, class ConstantsOf>
std::optional<Blends<Constants>> blends_of(const PlainContext& context, const Params& params,
                                           ConstantsOf&& constants_of) {
    if (!context.lower) return std::nullopt;
    Blends<Constants> blends{{}, &context.mixing->flow, &context.mixing->bed};
    for (int blend = 0; blend < kBlends; ++blend)
        blends.constants[static_cast<std::size_t>(blend)] =
            constants_of(blended(params, *context.lower, blend));
    return blends;
}

}  // namespace sim
