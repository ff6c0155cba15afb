#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include "terrains/references.h"
#include "terrains/resample.h"
#include "terrains/terrain.h"

namespace terrains {

// Reads a mountain from an elevation raster (the formats in README.md), first band, and brings
// it on to a grid of square cells with `squares` (8 to 4096) along its longer side. Vertices run from the
// first pixel's centre to the last one's; every plane is reproduced exactly, finer rasters are antialiased
// (PlaneFit).
//
// Plane. A coordinate system in metres that are true to 0.5 % here (UTM, national grids) keeps its own axes.
// Degrees, feet, Web Mercator and rotated rasters are laid on the transverse Mercator plane through the
// raster's centre. No coordinate system at all: the file's metres, unnamed. A .prj beside an .asc counts.
//
// No data. What the file declares (value, mask, alpha), NaN always, and −9999 and −32768 even where the file
// forgets to say so; there has_data is 0 and the surface carries the neighbours' slope on. Scale, offset and
// a vertical unit of feet are applied. cover is 0 everywhere. The licence is what the file's metadata says of
// its copyright.
//
// Files. It reads `path`, and the files beside it that are parts of it (RasterFiles), and with
// References::kAllowed also those that a virtual raster (VRT) names; never the network.
//
// Errors, in one sentence that names file and fact: missing, not a raster, a raster that refers elsewhere,
// damaged or cut short, nothing but no data, over 400 million pixels or 100,000 along a side, a height that
// is infinite or outside −12,000 to 9,000 m, a vertical unit nobody knows, no position of its pixels, degrees
// that span more than 2°, squares out of range, a grid that is not allowed. A text file cut within its very
// last number cannot be told from a whole one.
tl::expected<Terrain, std::string> read_dem(const std::filesystem::path& path, const GridChoice& choice,
                                            References references = References::kRefused);

}  // namespace terrains
