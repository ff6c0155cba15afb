#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/core/grid.h"
#include "terrains/georeference.h"

namespace terrains {

// A mountain on the grid it will be played on: what every reader and generator returns.
// Fields are grid.nx × grid.ny, row-major, x fastest, row 0 the south, without a halo.
struct Terrain {
    std::string name;     // "alr_utm32n.tif", "alpine-valley"
    std::string licence;  // what the source says of its licence; empty where it says nothing
    sim::Grid grid;

    std::vector<float> surface;  // m, height of the ground with its cover; where has_data is 0, the
                                 // neighbours' slope carried on
    std::vector<float>
        cover;  // m, erodible depth that a generator lays, 0 ≤ cover; bedrock = surface − cover
    std::vector<std::uint8_t>
        has_data;  // 1 where the source knows the ground, 0 where material leaves the world

    Georeference georeference;  // where the grid's (0, 0) stands on Earth; not placed for generated terrain
};

}  // namespace terrains
