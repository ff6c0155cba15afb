#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "terrains/georeference.h"

namespace terrains {

// A polygon from a file on the terrain's plane. Points within an odd number of its rings are inside: the
// first ring bounds it, the others are holes.
struct Area {
    std::vector<std::vector<LocalPoint>> rings;
    double thickness = 0;  // m, vertical
};

// Whether a file begins with a brace, as JSON does. Any other file is read as a raster.
bool looks_like_json(const std::filesystem::path& path);

// Reads the polygons and multipolygons of a GeoJSON file (RFC 7946: WGS 84 degrees, longitude first): a
// feature collection, one feature or one bare geometry. thickness is 0 unless `property` names a number that
// every feature must have, 0 < number ≤ 100 m. If it is missing, default_value is used, if given. Errors, in
// one sentence that names file and byte or feature (counted from 1): missing file, over 64 MiB, not JSON, a
// geometry that is no polygon, a ring of under 4 points or over a million points in all, coordinates that are
// not degrees, a coordinate system other than WGS 84, the number missing or out of range, terrain not placed.
struct ThicknessRule {
    std::string property;
    std::optional<double> default_value;
};
tl::expected<std::vector<Area>, std::string> read_areas(const std::filesystem::path& path,
                                                        const Georeference& georeference,
                                                        const ThicknessRule& rule);

}  // namespace terrains
