#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "terrains/references.h"
#include "terrains/terrain.h"

namespace terrains {

// How thickness is measured. A layer on a slope of θ is 1/cosθ times as thick vertically as normal to the slope.
enum class Thickness { kVertical, kNormal };

// Reads the release: a thickness in vertical metres per vertex of the terrain's grid, from one of
//   GeoJSON       polygons in WGS 84 degrees with the property `thickness` (vertical m) or `thickness_normal`
//                 (m normal to the slope of the terrain's surface). A vertex gets the thickness times the
//                 covered share of its cell, from 8 × 8 samples. The volume is accurate to one per cent for
//                 areas of some 10 cells or more. Where polygons overlap the thickest counts.
//   depth raster  any raster that read_dem() reads, metres, up to 100 million pixels; no data is 0. It is
//                 resampled by coordinates, never by index, bilinear between pixel centres, so that its
//                 volume is conserved. A raster without a coordinate system shares the terrain's, unless the
//                 terrain uses a local plane of its own. If all values are ≤ 0, they are a lowering and
//                 count as their amounts. Both signs in one file are refused, because the meaning is
//                 ambiguous. `measured` tells how it is measured, by default vertically.
// Where the terrain has no data the thickness is 0, because material there would leave the world at once.
// Errors, in one sentence that names the file: those of read_areas(), a damaged raster, a depth over 200 m,
// two files that cannot be aligned, `measured` given for GeoJSON, and a release that touches no ground of the
// grid. `files` gets every file that was read, unless null.
tl::expected<std::vector<float>, std::string> read_release(
    const std::filesystem::path& path, const Terrain& terrain, std::optional<Thickness> measured = {},
    References references = References::kRefused, std::vector<std::filesystem::path>* files = nullptr);

// A reference to compare with, observed or simulated: one of the two fields, the other is empty.
struct Reference {
    std::vector<std::uint8_t> extent;  // 1 where the avalanche was
    std::vector<float> change;         // change of surface height, m, below 0 where lowered

    std::vector<std::filesystem::path> files = {};  // that it was read from

    bool empty() const { return extent.empty() && change.empty(); }
};

// Reads an extent from GeoJSON, else the change of height from a raster (a "DEM of difference"). It is
// resampled as a depth raster, but signs count, and no data is no change. Errors: those of read_extent() and
// read_release().
tl::expected<Reference, std::string> read_reference(const std::filesystem::path& path, const Terrain& terrain,
                                                    References references = References::kRefused);

// 1 where at least half a vertex's cell lies in the file's polygons: an observed or simulated extent to
// compare with. GeoJSON as above, thickness not needed. Counts no-data vertices too. Errors as above.
tl::expected<std::vector<std::uint8_t>, std::string> read_extent(const std::filesystem::path& path,
                                                                 const Terrain& terrain);

}  // namespace terrains
