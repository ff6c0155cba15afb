#pragma once

#include "render/camera.h"
#include "sim/world/state.h"

namespace render {

// A camera that shows the whole terrain from slightly above: it stands on the low side, a little off the fall
// line so that slopes are seen across, as near as a picture of 16:9 allows. Flat ground is seen from the
// south.
Camera overview(const sim::View& world);

}  // namespace render
