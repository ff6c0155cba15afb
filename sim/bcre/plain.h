#pragma once

#include <cstdint>

// A sub-step of `bcre` stage by stage over whole fields: the step as it reads, beside the sweep that does the
// same row after row (sweep/).

namespace sim {

class Workers;
struct Params;
template <class Number>
struct Layers;
template <class Number>
struct Scratch;
template <class Number>
struct Substep;

namespace bcre {

template <class Scalar>
struct Work;

// All rows of a world, for stages of its sub-step.
template <class Number>
Work<Number> work_of(Layers<Number>& layers, const Params& params, Scratch<Number>& scratch,
                     Substep<Number> sub);

template <class Number>
void substep(Layers<Number>& layers, const Params& params, Scratch<Number>& scratch, Workers& workers,
             Substep<Number> sub);

// What the last sub-step carried into drains, in whole quanta.
std::int64_t drained(Layers<float>& layers, const Params& params, Scratch<float>& scratch);

// For who looks on: the velocity at the end of a tick, 0 where nothing rolls.
void find_velocity(Layers<float>& layers, const Params& params, Scratch<float>& scratch, Workers& workers);

}  // namespace bcre
}  // namespace sim
