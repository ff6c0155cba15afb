#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "terrains/references.h"
#include "terrains/terrain.h"

namespace terrains {

// Mean depth over each vertex's cell, vertical m, from a raster of depths; signs, systems, limits and errors
// as described with read_release(). A pixel counts with its whole area, so the volume is kept.
tl::expected<std::vector<float>, std::string> read_depth_raster(const std::filesystem::path& path,
                                                                const Terrain& terrain,
                                                                References references);
// The same with the signs that it has.
tl::expected<std::vector<float>, std::string> read_signed_raster(const std::filesystem::path& path,
                                                                 const Terrain& terrain,
                                                                 References references);

}  // namespace terrains
