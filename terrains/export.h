#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "sim/core/grid.h"
#include "terrains/georeference.h"

namespace terrains {

// Writes fields of grid.nx × grid.ny values, row-major, row 0 the south. Files are written atomically
// (files/whole_file.h). A vertex becomes the pixel around it, so the raster extends half a cell beyond the
// outer vertices. NaN is written as no data, −9999. The coordinate system is the georeference's. A grid
// without one is written in its metres, and no system is named. An error is one sentence with the file and
// the system's message.
using Written = tl::expected<void, std::string>;

// GeoTIFF, float32, deflate.
Written write_geotiff(const std::filesystem::path& path, const sim::Grid& grid,
                      const Georeference& georeference, std::span<const float> field);

// What the header of an ESRI ASCII file places, and how the file writes no data.
enum class AsciiStyle {
    kCorner,   // xllcorner, yllcorner: the corner of the south-west pixel; −9999
    kCentred,  // xllcenter, yllcenter: its centre, as in ISeeSnow's files; nan
};

// ESRI ASCII. Each float has enough digits to restore it exactly. The coordinate system goes into a .prj
// beside the file; an existing .prj of that name is replaced or removed.
Written write_ascii(const std::filesystem::path& path, const sim::Grid& grid,
                    const Georeference& georeference, std::span<const float> field,
                    AsciiStyle style = AsciiStyle::kCorner);

// GeoJSON (RFC 7946): one polygon, with its holes, around each connected patch of vertices whose mask is not
// 0, along the borders of their cells. Each has `area_m2`. Coordinates are WGS 84 degrees if the grid is
// placed, else the grid's own metres; then the collection's member `coordinates` is "local metres".
Written write_outlines(const std::filesystem::path& path, const sim::Grid& grid,
                       const Georeference& georeference, std::span<const std::uint8_t> mask);

// More of a polygon: names of letters and _, and numbers.
using Properties = std::vector<std::pair<std::string, double>>;
// The same around patches that are numbered already: per vertex a number, from 1 and none left out, or 0; the cells of a
// number are joined by their sides. `properties`: more of each patch, from number 1; may be shorter.
Written write_areas(const std::filesystem::path& path, const sim::Grid& grid,
                    const Georeference& georeference, std::span<const int> patch,
                    std::span<const Properties> properties);

}  // namespace terrains
