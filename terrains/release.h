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

// What slides off at the start: a thickness in vertical metres per vertex of the terrain's grid, from one of
//   GeoJSON       polygons in WGS 84 degrees with the property `thickness` (vertical m); where it is missing,
//                 default_thickness, if given. A vertex gets the thickness times the share of its cell that
//                 is covered, measured with 8 × 8 samples, so that the volume is right to a per cent from
//                 some 10 cells on. Where polygons overlap the thickest counts.
//   depth raster  any raster that read_dem() reads, metres, up to 100 million pixels; no data is 0. Brought
//   over by
//                 coordinates, never by index, bilinear between pixel centres, so that its volume is kept; a
//                 raster without a coordinate system shares the terrain's, unless the terrain lies on a local
//                 plane of its own. Values all ≤ 0 are a lowering and count as their amounts; both signs in
//                 one file are refused, for nobody could say which is meant.
// Where the terrain has no data the thickness is 0: material there would leave the world at once.
// Errors, in one sentence that names the file: what read_areas() refuses, a damaged raster, a depth over 200
// m, two files that cannot be joined, and a release that touches no ground of the grid.
tl::expected<std::vector<float>, std::string> read_release(const std::filesystem::path& path,
                                                           const Terrain& terrain,
                                                           std::optional<double> default_thickness = {},
                                                           References references = References::kRefused);

// What people observed or another program found, to compare with: one of the two, the other is empty.
struct Reference {
    std::vector<std::uint8_t> extent;  // 1 where the avalanche was
    std::vector<float> change;         // m by which the surface was raised, below 0 lowered

    bool empty() const { return extent.empty() && change.empty(); }
};

// An extent from GeoJSON, else the change of height from a raster (a "DEM of difference"): brought over as a
// depth raster, but signs count, and no data is no change. Errors as of read_extent() and read_release().
tl::expected<Reference, std::string> read_reference(const std::filesystem::path& path, const Terrain& terrain,
                                                    References references = References::kRefused);

// 1 where at least half a vertex's cell lies in the file's polygons: an observed or simulated extent to
// compare with. GeoJSON as above, thickness not needed. Counts no-data vertices too. Errors as above.
tl::expected<std::vector<std::uint8_t>, std::string> read_extent(const std::filesystem::path& path,
                                                                 const Terrain& terrain);

}  // namespace terrains
