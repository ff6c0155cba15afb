#pragma once

#include "render/picture.h"
#include "sim/front/tracker.h"

namespace render {

// A tracker's mesh from above, north at the top: its edges, the triangles that are cut, the pieces of front
// within them and the points. As large as fits into width × height pixels with a margin.
Picture front_picture(const sim::front::Tracker& tracker, int width, int height);

}  // namespace render
