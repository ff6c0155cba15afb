#pragma once

#include <span>

#include "render/flow/carried.h"

namespace render {

// Moves a boulder on through `dt_s`: a flow carries it, or it rolls, bounces and stops. `first_depth`: as of Carried.
void move_boulder(const sim::View& world, std::span<const float> first_depth, float dt_s, CarriedBody& body);

}  // namespace render
