#pragma once

#include "render/pictures/picture.h"

namespace game {

struct Comparison;

enum class MapOf { kDeposit, kPeakDepth };

// A map of where the second of two worlds has more and less than the first, on the ground from above, with a
// legend. Red and blue (ColorBrewer RdBu, Brewer and Harrower 2003) are safe for colour-blind viewers, in
// four classes each. Also shows both extents and the commands that only one has.
render::Picture difference_map(const Comparison& comparison, MapOf of);

}  // namespace game
