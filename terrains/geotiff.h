#pragma once

#include <span>
#include <string>

#include <tl/expected.hpp>

#include "sim/core/grid.h"
#include "terrains/georeference.h"

namespace terrains {

inline constexpr float kNoDataWritten = -9999;

// Edges of a raster whose pixels lie around the vertices of a grid, in the georeference's metres.
inline double west_edge(const sim::Grid& grid, const Georeference& place) {
    return place.origin_x() - 0.5 * grid.dx;
}
inline double south_edge(const sim::Grid& grid, const Georeference& place) {
    return place.origin_y() - 0.5 * grid.dx;
}

// The bytes of a GeoTIFF, float32, deflate. `rows` run from the north to the south. Errors: GDAL's words.
tl::expected<std::string, std::string> encode_geotiff(const sim::Grid& grid, const Georeference& place,
                                                      std::span<const float> rows);

// A coordinate system in the dialect that readers of .prj files know; empty if it cannot be said in it.
std::string esri_wkt(const std::string& wkt);

}  // namespace terrains
