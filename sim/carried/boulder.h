#pragma once

#include <span>

#include "sim/carried/carried.h"

namespace sim::carried {

// Moves a boulder on through `dt_s`: a flow carries it, or it rolls, bounces and stops. `first_depth`: as of Carried.
void move_boulder(const View& world, std::span<const float> first_depth, float dt_s, Body& body);

}  // namespace sim::carried
