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

// Where the material of a file went, vertical m³ on the terrain's plane.
struct ReleaseVolumes {
    double in_file =
        0;  // exact for polygons; beyond the grid a thickness normal to the slope has its mean slope
    double on_ground = 0;   // on the known ground of the grid: what a run begins with
    double outside = 0;     // beyond the grid's cells
    double on_no_data = 0;  // where the terrain has no data: material there would leave the world at once
    double overlap = 0;     // where polygons overlap, of which only the thickest counts

    double lost() const { return outside + on_no_data + overlap; }
    bool much_is_lost() const { return lost() > 0.01 * in_file; }
};

struct Release {
    std::vector<float> thickness;  // vertical m per vertex of the terrain's grid
    ReleaseVolumes volumes;
    bool vertical = false, normal = false;  // in which ways the file's thickness was taken to be measured
    std::size_t without_geometry = 0;       // features that were skipped

    std::vector<std::filesystem::path> files = {};  // that it was read from
};

// Reads the release from one of
//   GeoJSON       polygons in WGS 84 degrees with the property `thickness` (vertical m) or `thickness_normal`
//                 (m normal to the slope of the terrain's surface). A vertex gets the thickness times the
//                 covered share of its cell, from 8 × 8 samples. The volume is accurate to one per cent for
//                 areas of some 10 cells or more. Where polygons overlap the thickest counts. Features whose geometry is
//                 null are skipped and counted.
//   depth raster  any raster that read_dem() reads, of up to 100 million pixels; no data is 0. Its unit, scale and
//                 offset are applied (raster_values.h). It is resampled by coordinates, never by index, bilinear
//                 between pixel centres, so that its volume is conserved. A raster without a coordinate system shares
//                 the terrain's, unless the terrain uses a local plane of its own. If all values are ≤ 0, they are a
//                 lowering and count as their amounts. Both signs in one file are refused, because the meaning is
//                 ambiguous.
// `measured` tells how a raster or `thickness` is measured, by default vertically.
// Errors, in one sentence that names the file: those of read_areas(), a damaged raster, a depth over 200 m,
// two files that cannot be aligned, polygons of another format, thickness_normal that is said to be vertical, and a
// release that touches no ground of the grid.
tl::expected<Release, std::string> read_release(const std::filesystem::path& path, const Terrain& terrain,
                                                std::optional<Thickness> measured = {},
                                                References references = References::kRefused);

// What one polygon of a release holds by itself, whatever others overlap it.
struct ReleasePatch {
    std::vector<std::uint32_t>
        vertices;                  // with known ground and some of it, ascending; none if it lies elsewhere
    std::vector<float> thickness;  // vertical m at each of them
    double volume = 0;             // m³ on this ground
};

// Reads each polygon of a GeoJSON file, in its order, as read_release() reads them all. Errors: those of read_release(),
// and a file that is a raster.
tl::expected<std::vector<ReleasePatch>, std::string> read_release_patches(const std::filesystem::path& path,
                                                                          const Terrain& terrain,
                                                                          std::optional<Thickness> measured);

// A reference to compare with, observed or simulated: one of the two fields, the other is empty.
struct Reference {
    std::vector<std::uint8_t> extent;  // 1 where the avalanche was
    std::vector<float> change;         // change of surface height, m, below 0 where lowered

    double in_file = 0,
           outside = 0;  // of the whole file, and beyond the grid; m² of an extent, m³ of changes
    std::size_t without_geometry = 0;
    std::vector<std::filesystem::path> files = {};  // that it was read from

    bool empty() const { return extent.empty() && change.empty(); }
};

// Reads an extent from GeoJSON (1 where at least half a vertex's cell lies in its polygons, also without data;
// thickness not needed), else the change of height from a raster (a "DEM of difference"). It is resampled as a depth
// raster, but signs count, and no data is no change. Errors: those of read_areas() and read_release(), and a file
// without anything on the grid.
tl::expected<Reference, std::string> read_reference(const std::filesystem::path& path, const Terrain& terrain,
                                                    References references = References::kRefused);

}  // namespace terrains
