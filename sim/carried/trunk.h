#pragma once

#include <span>

#include "sim/carried/carried.h"

namespace sim::carried {

// Diameter of a trunk at its root, m.
float thickness_of(const Body& trunk);

// Moves a trunk on through `dt_s`. A flow takes hold of both halves, so that the trunk travels with its mean and turns with
// its shear, as a long thin body does (Jeffery 1922). `first_depth`: as of Carried.
void move_trunk(const View& world, std::span<const float> first_depth, float dt_s, Body& trunk);

}  // namespace sim::carried
