#pragma once

#include <span>

#include "render/flow/carried.h"

namespace render {

// Diameter of a trunk at its root, m.
float thickness_of(const CarriedBody& trunk);

// Moves a trunk on through `dt_s`. A flow takes hold of both halves, so that the trunk travels with its mean and turns with
// its shear, as a long thin body does (Jeffery 1922). `first_depth`: as of Carried.
void move_trunk(const sim::View& world, std::span<const float> first_depth, float dt_s, CarriedBody& trunk);

}  // namespace render
