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
    double thickness = 0;  // m
    bool normal = false;   // the thickness is measured normal to the slope, not vertically
};

// Whether a file begins with a brace, as JSON does. Any other file is read as a raster.
bool looks_like_json(const std::filesystem::path& path);

// The properties of a feature that give its thickness, 0 < m ≤ 100; every feature has exactly one of them.
struct ThicknessNames {
    std::string vertical = "thickness", normal = "thickness_normal";
    // Measured normal to the slope in both, as in a file of AvaFrame.
    bool both_normal = false;
};

// What a GeoJSON file has.
struct Areas {
    std::vector<Area> areas;
    std::size_t without_geometry = 0;  // features whose geometry is null, which RFC 7946 allows
};

// Reads the polygons and multipolygons of a GeoJSON file (RFC 7946: WGS 84 degrees, longitude first): a
// feature collection, one feature or one bare geometry. Without `names` the thickness is 0. Errors, in one
// sentence that names file and byte or feature (counted from 1): missing file, over 64 MiB, not JSON, a
// geometry that is no polygon, a ring of under 4 points or over a million points in all, coordinates that are
// not degrees, a coordinate system other than WGS 84, a thickness missing, given twice or out of range, no feature
// with a geometry, terrain not placed.
tl::expected<Areas, std::string> read_areas(const std::filesystem::path& path,
                                            const Georeference& georeference,
                                            const std::optional<ThicknessNames>& names);

}  // namespace terrains
