#pragma once

#include "sim/world/state.h"

namespace render {

// Lowest and highest bedrock as it is by nature, without earth, buildings and no-data vertices, m above datum.
struct HeightRange {
    float lowest = 0, highest = 0;
};

// Scans every vertex of a world. Both heights are 0 if there is no ground at all.
HeightRange height_range(const sim::View& world);

}  // namespace render
