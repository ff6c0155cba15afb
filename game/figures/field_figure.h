#pragma once

#include "render/pictures/picture.h"
#include "sim/fields/test_flows.h"

namespace game {

// Draws the unit square from above with a flow's velocities as arrows and its fronts dashed, at `time`, s.
// `pixels` along each side.
render::Picture field_picture(const sim::fields::TestFlow& flow, double time, int pixels);

}  // namespace game
