#pragma once

namespace terrains {

// Whether a file may lead to other files: a virtual raster names its sources, a scene its terrain. Nothing
// here ever asks the network.
enum class References { kRefused, kAllowed };

}  // namespace terrains
