#pragma once

#include "sim/core/angle.h"
#include "sim/core/grid.h"

namespace sim {
template <class Number>
struct Layers;
}

namespace sim::weather {

// What stands in a straight stream along `to`, unit vector in plan, that falls by `slope`: of light, or of wind that closes
// behind a ridge. `over` becomes the height of its lower edge above the surface b + d, m: 0 where the stream arrives.
void cast(const Layers<float>& layers, Direction to, double slope, Field<float>& over);

}  // namespace sim::weather
