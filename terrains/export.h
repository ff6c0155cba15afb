#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "sim/core/grid.h"
#include "terrains/georeference.h"

namespace terrains {

// Fields taken away again, grid.nx × grid.ny values each, row-major, row 0 the south. Every file is a
// whole one (files/whole_file.h). A vertex becomes the pixel around
// it: the raster reaches half a cell beyond the outer vertices. NaN is written as no data, −9999. The
// coordinate system is the georeference's; a grid without one is written in its metres, and no system is
// named. Errors: one sentence that names the file and what the machine said.
using Written = tl::expected<void, std::string>;

// GeoTIFF, float32, deflate.
Written write_geotiff(const std::filesystem::path& path, const sim::Grid& grid,
                      const Georeference& georeference, std::span<const float> field);

// ESRI ASCII, every float in as many digits as bring it back exactly, and the coordinate system in a .prj
// beside it; a .prj that stood there for another raster of that name is replaced or removed.
Written write_ascii(const std::filesystem::path& path, const sim::Grid& grid,
                    const Georeference& georeference, std::span<const float> field);

// GeoJSON (RFC 7946): one polygon, with its holes, around each connected patch of vertices where mask is not
// 0, along the borders of their cells; each with `area_m2`. WGS 84 degrees where the grid is placed, else the
// grid's own metres, and then the member `coordinates` of the collection says "local metres".
Written write_outlines(const std::filesystem::path& path, const sim::Grid& grid,
                       const Georeference& georeference, std::span<const std::uint8_t> mask);

}  // namespace terrains
