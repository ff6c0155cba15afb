#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/core/grid.h"
#include "terrains/georeference.h"

namespace terrains {

// A mountain on the simulation's grid. Every reader and generator returns one.
// Fields are grid.nx × grid.ny, row-major, x fastest, row 0 the south, without a halo.
struct Terrain {
    std::string name;     // "alr_utm32n.tif", "alpine-valley"
    std::string licence;  // licence stated by the source; empty if none
    sim::Grid grid;

    // Height of the ground with its cover, m. Where has_data is 0, it extends the neighbours' slope.
    std::vector<float> surface;
    // Erodible depth from a generator, m, ≥ 0; bedrock = surface − cover.
    std::vector<float> cover;
    // 1 where the source has data, 0 where material leaves the world.
    std::vector<std::uint8_t> has_data;

    Georeference georeference;  // position of the grid's (0, 0) on Earth; not placed for generated terrain

    // Every file that a raster was read from, and every one that it names. Empty for other terrains.
    std::vector<std::filesystem::path> files = {};

    // What the file states that is hardly meant, one sentence each, for the user to read.
    std::vector<std::string> warnings = {};
};

}  // namespace terrains
