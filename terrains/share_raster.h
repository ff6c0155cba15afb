#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "sim/core/grid.h"
#include "terrains/georeference.h"
#include "terrains/references.h"

namespace terrains {

// Reads a raster of the shares of each cell that crowns cover, 0 to 1, on a grid at this place: 0 to 255 per vertex, 0 where
// the raster has no data. `files` gets what was read. Errors, in one sentence: those of read_dem(), and a raster that is not
// of the same extent.
tl::expected<std::vector<std::uint8_t>, std::string> read_shares(const std::filesystem::path& file,
                                                                 const sim::Grid& grid,
                                                                 const Georeference& place,
                                                                 References references,
                                                                 std::vector<std::filesystem::path>& files);

}  // namespace terrains
