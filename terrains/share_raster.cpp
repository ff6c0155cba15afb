#include "terrains/share_raster.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "terrains/dem_gdal.h"

namespace terrains {
namespace {

namespace fs = std::filesystem;

bool is_same_place(const Georeference& a, const Georeference& b, double apart) {
    if (!a.has_coordinates() || !b.has_coordinates()) return true;  // a generated terrain is nowhere
    return (a.wkt().empty() || b.wkt().empty() || a.wkt() == b.wkt()) &&
           std::abs(a.origin_x() - b.origin_x()) <= apart && std::abs(a.origin_y() - b.origin_y()) <= apart;
}

std::string size_of(const sim::Grid& grid) {
    return fmt::format("{} × {} vertices of {:.6g} m", grid.nx, grid.ny, grid.dx);
}

}  // namespace

tl::expected<std::vector<std::uint8_t>, std::string> read_shares(const fs::path& file, const sim::Grid& grid,
                                                                 const Georeference& place,
                                                                 References references,
                                                                 std::vector<fs::path>& files) {
    const auto raster =
        read_dem(file, GridChoice(std::max(grid.nx, grid.ny) - 1), references, Quantity::kShare);
    if (!raster) return tl::unexpected(raster.error());
    files.insert(files.end(), raster->files.begin(), raster->files.end());
    const sim::Grid& own = raster->grid;
    const double cell = grid.dx;
    if (own.nx != grid.nx || own.ny != grid.ny || std::abs(static_cast<double>(own.dx) - cell) > 0.01 * cell)
        return tl::unexpected(fmt::format("{}: spans {}, and the grid has {}; they must be the same",
                                          file.string(), size_of(own), size_of(grid)));
    if (!is_same_place(raster->georeference, place, 0.5 * cell))
        return tl::unexpected(fmt::format(
            "{}: begins at {:.1f}, {:.1f}, and the grid at {:.1f}, {:.1f}; they must be at the same place",
            file.string(), raster->georeference.origin_x(), raster->georeference.origin_y(), place.origin_x(),
            place.origin_y()));
    std::vector<std::uint8_t> shares(grid.size());
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (raster->has_data[i] == 0) continue;
        // The reader bounds them, but between pixels a plane is fitted, which may lie a little beyond.
        const double share = raster->surface[i];
        shares[i] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
    }
    return shares;
}

}  // namespace terrains
