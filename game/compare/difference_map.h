#pragma once

#include "render/picture.h"

namespace game {

struct Comparison;

enum class MapOf { kDeposit, kPeakDepth };

// Where the second of two worlds has more and less than the first, on the ground from above, with a legend:
// red and blue (ColorBrewer RdBu, Brewer and Harrower 2003), which people without one kind of cone tell
// apart, in four classes each; the extents of both, and the commands that they do not share.
render::Picture difference_map(const Comparison& comparison, MapOf of);

}  // namespace game
