#pragma once

namespace terrains {

// Whether a file may refer to other files: a virtual raster names its sources, a scene its terrain. The
// network is never used.
enum class References { kRefused, kAllowed };

}  // namespace terrains
