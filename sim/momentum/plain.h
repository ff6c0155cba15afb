#pragma once

#include "sim/momentum/fields.h"
#include "sim/world/forward.h"

// A sub-step of a model with momentum, stage by stage over whole fields. It is the readable reference for the
// sweep, which runs the same stages row after row (sweep/).

namespace sim::momentum {

// Returns all rows of a world for the stages of a sub-step.
template <class Number>
StageRows<Number> stage_rows(Layers<Number>& layers, const Params& params, Fields<Field<Number>>& fields,
                             Substep<Number> sub);

template <class Number>
void substep(Layers<Number>& layers, const Params& params, Fields<Field<Number>>& fields,
             const PlainContext& context, Workers& workers, Substep<Number> sub);

}  // namespace sim::momentum
