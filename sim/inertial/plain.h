#pragma once

#include "sim/world/forward.h"

// A sub-step of `bcre-inertial` stage by stage over whole fields: the step as it reads, beside the sweep that
// does the same row after row (sweep/).

namespace sim::inertial {

template <class Scalar>
struct Work;

// All rows of a world, for stages of its sub-step.
template <class Number>
Work<Number> work_of(Layers<Number>& layers, const Params& params, Scratch<Number>& scratch,
                     Substep<Number> sub);

template <class Number>
void substep(Layers<Number>& layers, const Params& params, Scratch<Number>& scratch, Workers& workers,
             Substep<Number> sub);

}  // namespace sim::inertial
