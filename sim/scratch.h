#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "sim/bcre/fields.h"
#include "sim/core/grid.h"
#include "sim/momentum/fields.h"
#include "sim/stages/plain_context.h"
#include "sim/world/layers.h"
#include "sim/world/params.h"

namespace sim {

// What a plain step needs between its stages; holds nothing from one sub-step to the next. Made once per
// world, so that a step allocates nothing.
template <class Number>
struct Scratch {
    Scratch(const Layers<Number>& layers, Model model);

    using Bcre = bcre::Fields<Field<Number>>;
    using Momentum = momentum::Fields<Field<Number>>;
    std::variant<Bcre, Momentum> fields;  // of the model
    Bcre& bcre() { return std::get<Bcre>(fields); }
    Momentum& momentum() { return std::get<Momentum>(fields); }

    // Through the faces, in the last sub-step, m.
    struct Fluxes {
        Field<Number>&x, &y;
    };
    Fluxes fluxes();

    std::vector<std::int64_t> limited;  // of each row, in the last sub-step (State::limited)

    PlainContext context;
};

// Takes how many vertices the last sub-step limited.
std::int64_t take_limited(Scratch<float>& scratch);

// What the fluxes of the last sub-step carried into drains, in whole quanta.
std::int64_t drained(Scratch<float>& scratch);

}  // namespace sim
