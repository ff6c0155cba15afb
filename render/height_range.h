#pragma once

#include "sim/world/state.h"

namespace render {

// Lowest and highest bedrock where there is ground, m above datum.
struct HeightRange {
    float lowest = 0, highest = 0;
};

// Of a whole world: one look at every vertex. Both 0 where there is no ground at all.
HeightRange height_range(const sim::View& world);

}  // namespace render
