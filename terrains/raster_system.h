#pragma once

#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "terrains/gdal_support.h"

namespace terrains {

// WKT of a raster's horizontal coordinate system, and metres per unit of its axes and of its heights. The WKT is
// empty if the file states no system.
struct RasterSystem {
    std::string wkt;
    bool geographic = false;
    bool projected = false;
    double metres_per_unit = 1;    // of a projected system's axes
    double metres_per_height = 1;  // of its vertical system; 1 if it states none
    bool counts_down = false;      // its vertical system has depths below a level
};

// The system that a raster states: GDAL's, or else that of a .prj beside it, if it is a format whose system has its
// place there and which GDAL leaves unread: WKT 1 or 2, ESRI's lines, or a code. An error names a .prj that is there and cannot be read.
tl::expected<RasterSystem, std::string> system_of(const Raster& raster);

// Reads WKT 1 or 2 or a code: "EPSG:32632", in any case, with a vertical system as "EPSG:32632+5773", or the number
// alone. Nothing else, because other forms may name files or addresses.
std::optional<RasterSystem> read_system(const std::string& text);

}  // namespace terrains
