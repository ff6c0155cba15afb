#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include "terrains/quantity.h"
#include "terrains/references.h"
#include "terrains/resample.h"
#include "terrains/terrain.h"

namespace terrains {

// Reads a mountain from the first band of an elevation raster (formats in README.md) and resamples it to
// square cells with `squares` (8 to 4096) along the longer side, or with its own pixels. Vertices run from the first pixel's centre
// to the last one's. Every plane is reproduced exactly, and finer rasters are antialiased (PlaneFit).
//
// Plane. A coordinate system in metres that are true to 0.5 % here (UTM, national grids) keeps its own axes.
// Rasters in degrees, feet or Web Mercator and rotated rasters are projected to the transverse Mercator plane
// through the raster's centre. Without a coordinate system the file's metres are used, unnamed. A .prj beside
// the raster counts.
//
// Values. raster_values.h says which unit, scale and offset they have and which of them are no data. There
// has_data is 0 and the surface extends the neighbours' slope. `quantity`: heights, or shares of a wood. cover is 0
// everywhere. The licence is the copyright stated in the file's metadata. A cliff that no mountain has is a warning.
//
// Files. Reads `path` and the files beside it that are parts of it (RasterFiles). With References::kAllowed
// it also reads those that a virtual raster (VRT) names. It never uses the network.
//
// Errors, in one sentence that names file and fact: missing, not a raster, a raster that refers elsewhere,
// those of RasterValues, nothing but no data, pixels without a position, degrees that span more than 2°, a .prj that
// cannot be read, squares out of range, a grid that is not allowed. A text file cut within its very last number cannot
// be distinguished from a whole one.
tl::expected<Terrain, std::string> read_dem(const std::filesystem::path& path, const GridChoice& choice,
                                            References references = References::kRefused,
                                            Quantity quantity = Quantity::kHeight);

// Gives a DEM that names no coordinate system one in metres, such as "EPSG:31287", "EPSG:31287+5778" or WKT. Nothing is
// read from the network. Errors, in one sentence: the DEM has a system, the text names none, its unit or that of its
// heights is not the metre, or it is not true to 0.5 % there.
tl::expected<void, std::string> set_system(const std::string& system, Terrain& terrain);

}  // namespace terrains
