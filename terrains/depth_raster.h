#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "terrains/references.h"
#include "terrains/terrain.h"

namespace terrains {

// Reads the mean depth over each vertex's cell, vertical m, from a raster of depths. Signs, systems, limits
// and errors are those of read_release(). A pixel counts with its whole area, so the volume is conserved.
// `files` gets every file that was read, unless null.
tl::expected<std::vector<float>, std::string> read_depth_raster(
    const std::filesystem::path& path, const Terrain& terrain, References references,
    std::vector<std::filesystem::path>* files = nullptr);
// The same, but keeps the signs.
tl::expected<std::vector<float>, std::string> read_signed_raster(
    const std::filesystem::path& path, const Terrain& terrain, References references,
    std::vector<std::filesystem::path>* files = nullptr);

}  // namespace terrains
