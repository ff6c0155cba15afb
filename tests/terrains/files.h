#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "terrains/release.h"
#include "terrains/terrain.h"

// Small files for the tests of terrains/, written into a folder of the test's own.
namespace terrains::test {

// m, the height of a plane at a point of the file's own coordinates.
using Height = std::function<double(double x, double y)>;

// An ESRI ASCII grid: pixel centres from (west, south), `cell` apart.
struct AsciiGrid {
    int columns = 21, rows = 17;
    double west = 0, south = 0;  // centre of the south-west pixel
    double cell = 10;
    std::string prj = std::string();                  // WKT of the .prj beside it; none if empty
    std::function<bool(int column, int row)> is_void  // row counted from the north
        = [](int, int) { return false; };
};
std::string ascii_text(const AsciiGrid& grid, const Height& height);
std::filesystem::path write_ascii_grid(const std::filesystem::path& folder, const std::string& name,
                                       const AsciiGrid& grid, const Height& height);

// The field of a release or an extent alone.
tl::expected<std::vector<float>, std::string> thickness_in(const std::filesystem::path& path,
                                                           const Terrain& terrain,
                                                           std::optional<Thickness> measured = {});
tl::expected<std::vector<std::uint8_t>, std::string> extent_in(const std::filesystem::path& path,
                                                               const Terrain& terrain);

void write_text(const std::filesystem::path& path, const std::string& text);
std::string read_text(const std::filesystem::path& path);

// Bilinear height of the surface at a point of the grid, m; NaN off the grid or next to a vertex without
// data.
double height_at(const Terrain& terrain, LocalPoint p);

// WKT of a coordinate system by its EPSG number, as an ESRI .prj has it. For the numbers the tests use.
std::string utm_32n();
std::string utm_32n_in_feet();
std::string degrees();
std::string web_mercator();

}  // namespace terrains::test
