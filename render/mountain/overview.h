#pragma once

#include "render/view/camera.h"
#include "sim/world/state.h"

namespace render {

// Returns a camera that shows the whole terrain from slightly above. It stands on the low side, a little off
// the fall line so that slopes are seen obliquely, as near as a 16:9 image allows. It views flat ground from
// the south.
Camera overview(const sim::View& world);

// Returns a camera for a terrain with mountains around it: from the same side, but lower and so near that the
// terrain's borders are outside of the image.
Camera landscape_view(const sim::View& world);

}  // namespace render
