#pragma once

#include "render/pictures/picture.h"
#include "sim/front/tracker.h"

namespace render {

// Draws a tracker's mesh from above, north at the top: its edges, the cut triangles, their front segments and
// the points. The drawing is as large as fits into width × height pixels with a margin.
Picture front_picture(const sim::front::Tracker& tracker, int width, int height);

}  // namespace render
