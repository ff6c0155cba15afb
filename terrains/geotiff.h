#pragma once

#include <span>
#include <string>

#include <tl/expected.hpp>

#include "sim/core/grid.h"
#include "terrains/georeference.h"

namespace terrains {

inline constexpr float kNoDataWritten = -9999;

// Edges of a raster with pixels around the vertices of a grid, in the georeference's metres.
inline double west_edge(const sim::Grid& grid, const Georeference& place) {
    return place.origin_x() - 0.5 * grid.dx;
}
inline double south_edge(const sim::Grid& grid, const Georeference& place) {
    return place.origin_y() - 0.5 * grid.dx;
}

// Encodes a GeoTIFF, float32, deflate. `rows` run from north to south. Errors are GDAL's messages.
tl::expected<std::string, std::string> encode_geotiff(const sim::Grid& grid, const Georeference& place,
                                                      std::span<const float> rows);

// A coordinate system in the WKT dialect of .prj files; empty if that dialect cannot express it.
std::string esri_wkt(const std::string& wkt);

}  // namespace terrains
