#include "tests/terrains/files.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace terrains::test {
namespace {

const char* const kWgs84 =
    R"(GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",SPHEROID["WGS_1984",6378137.0,298.257223563]],)"
    R"(PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]])";

std::string transverse_mercator_32n(const char* unit, double metres) {
    return fmt::format(
        R"(PROJCS["zone 32N",{},PROJECTION["Transverse_Mercator"],PARAMETER["False_Easting",{}],)"
        R"(PARAMETER["False_Northing",0.0],PARAMETER["Central_Meridian",9.0],)"
        R"(PARAMETER["Scale_Factor",0.9996],PARAMETER["Latitude_Of_Origin",0.0],UNIT["{}",{}]])",
        kWgs84, 500000 / metres, unit, metres);
}

}  // namespace

std::string utm_32n() {
    return transverse_mercator_32n("Meter", 1.0);
}
std::string utm_32n_in_feet() {
    return transverse_mercator_32n("Foot", 0.3048);
}
std::string degrees() {
    return kWgs84;
}
std::string web_mercator() {
    return fmt::format(R"(PROJCS["WGS_1984_Web_Mercator_Auxiliary_Sphere",{},)"
                       R"(PROJECTION["Mercator_Auxiliary_Sphere"],PARAMETER["False_Easting",0.0],)"
                       R"(PARAMETER["False_Northing",0.0],PARAMETER["Central_Meridian",0.0],)"
                       R"(PARAMETER["Standard_Parallel_1",0.0],PARAMETER["Auxiliary_Sphere_Type",0.0],)"
                       R"(UNIT["Meter",1.0]])",
                       kWgs84);
}

tl::expected<std::vector<float>, std::string> thickness_in(const std::filesystem::path& path,
                                                           const Terrain& terrain,
                                                           std::optional<Thickness> measured) {
    return read_release(path, terrain, measured).map([](Release release) {
        return std::move(release.thickness);
    });
}

tl::expected<std::vector<std::uint8_t>, std::string> extent_in(const std::filesystem::path& path,
                                                               const Terrain& terrain) {
    return read_reference(path, terrain).map([](Reference reference) { return std::move(reference.extent); });
}

std::string ascii_text(const AsciiGrid& grid, const Height& height) {
    std::string text =
        fmt::format("ncols {}\nnrows {}\nxllcenter {}\nyllcenter {}\ncellsize {}\nNODATA_value -9999\n",
                    grid.columns, grid.rows, grid.west, grid.south, grid.cell);
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const double x = grid.west + column * grid.cell,
                         y = grid.south + (grid.rows - 1 - row) * grid.cell;
            text += fmt::format("{:.6f}{}", grid.is_void(column, row) ? -9999.0 : height(x, y),
                                column + 1 == grid.columns ? '\n' : ' ');
        }
    return text;
}

std::filesystem::path write_ascii_grid(const std::filesystem::path& folder, const std::string& name,
                                       const AsciiGrid& grid, const Height& height) {
    auto path = folder / (name + ".asc");
    write_text(path, ascii_text(grid, height));
    if (!grid.prj.empty()) write_text(folder / (name + ".prj"), grid.prj);
    return path;
}

void write_text(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

std::string read_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

double height_at(const Terrain& terrain, LocalPoint p) {
    const double u = p.x / terrain.grid.dx, v = p.y / terrain.grid.dx;
    const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
    double sum = 0;
    for (const int b : {0, 1})
        for (const int a : {0, 1}) {
            if (!terrain.grid.contains(i + a, j + b)) return std::numeric_limits<double>::quiet_NaN();
            const auto at = static_cast<std::size_t>(j + b) * terrain.grid.nx + (i + a);
            if (terrain.has_data[at] == 0) return std::numeric_limits<double>::quiet_NaN();
            sum += (a == 1 ? u - i : 1 - u + i) * (b == 1 ? v - j : 1 - v + j) * terrain.surface[at];
        }
    return sum;
}

}  // namespace terrains::test
