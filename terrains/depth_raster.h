#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "terrains/references.h"
#include "terrains/terrain.h"

namespace terrains {

// A raster of depths on a terrain's grid.
struct DepthRaster {
    std::vector<float> mean;  // depth over each vertex's cell, m
    double in_file = 0,
           outside = 0;  // m³ of the whole raster, and beyond the grid's cells; of amounts without sign
    std::vector<std::filesystem::path> files;  // that were read
};

// Reads depths in vertical m as amounts, or with their signs. Signs, systems, limits and errors are those of
// read_release(). A pixel counts with its whole area, so the volume is conserved.
tl::expected<DepthRaster, std::string> read_depth_raster(const std::filesystem::path& path,
                                                         const Terrain& terrain, References references);
tl::expected<DepthRaster, std::string> read_signed_raster(const std::filesystem::path& path,
                                                          const Terrain& terrain, References references);

}  // namespace terrains
