#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace terrains {

// For a file that is no raster and whose first bytes are those of a shapefile, GeoPackage, KML, GML, FlatGeobuf or
// archive: one sentence with the command that makes the GeoJSON of it which is read here. None for other files.
std::optional<std::string> advice_on_polygons(const std::filesystem::path& path);

}  // namespace terrains
