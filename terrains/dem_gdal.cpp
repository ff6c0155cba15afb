#include "terrains/dem_gdal.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "terrains/gdal_support.h"
#include "terrains/height_steps.h"
#include "terrains/pixel_blocks.h"
#include "terrains/raster_place.h"
#include "terrains/raster_values.h"
#include "terrains/resample.h"

namespace terrains {
namespace {

std::string licence_of(GDALDatasetH dataset) {
    for (const char* key : {"LICENSE", "LICENCE", "TIFFTAG_COPYRIGHT", "COPYRIGHT"})
        if (const char* value = GDALGetMetadataItem(dataset, key, nullptr)) return value;
    return {};
}

// Adds each pixel of a row.
void fit_row(const RasterPlace& place, int row, const std::vector<double>& heights, PlaneFit& fit) {
    std::vector<double> x, y;
    place.positions(row, x, y);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        if (std::isnan(x[i])) continue;
        const double from_origin_x = x[i] - place.min_x, from_origin_y = y[i] - place.min_y;
        if (std::isnan(heights[i]))
            fit.add_void(from_origin_x, from_origin_y);
        else
            fit.add(from_origin_x, from_origin_y, heights[i]);
    }
}

// Streams the raster from first to last row to the terrain's grid.
tl::expected<void, std::string> fill(RasterValues& rows, const RasterPlace& place, Terrain& terrain) {
    constexpr double kFinest = 16;  // pixels resolved along a cell
    const double dx = terrain.grid.dx;
    PlaneFit fit(terrain.grid, std::max(dx, place.reach_x), std::max(dx, place.reach_y), place.pixel_area);
    const int columns = rows.columns(), row_count = rows.rows();
    const int side = static_cast<int>(dx / (kFinest * std::max(place.reach_x, place.reach_y)));
    std::optional<PixelBlocks> blocks;
    if (side > 1) blocks.emplace(place, columns, row_count, side, fit);
    HeightSteps steps(place.reach_x, place.reach_y);
    std::vector<double> heights;
    for (int row = 0; row < row_count; ++row) {
        if (auto read = rows.read(row, heights); !read) return read;
        steps.add_row(heights);
        if (blocks)
            blocks->add_row(row, heights);
        else
            fit_row(place, row, heights, fit);
    }
    auto fitted = fit.finish();
    if (std::find(fitted.has_data.begin(), fitted.has_data.end(), 1) == fitted.has_data.end())
        return tl::unexpected<std::string>("it has no data anywhere, so the terrain has no ground");
    terrain.surface = std::move(fitted.surface);
    terrain.has_data = std::move(fitted.has_data);
    fill_voids(terrain.grid, terrain.has_data, terrain.surface);
    if (auto warning = steps.warning()) terrain.warnings.push_back(std::move(*warning));
    return {};
}

tl::expected<Terrain, std::string> read(const Raster& raster, const GridChoice& choice, Quantity quantity) {
    auto values = RasterValues::open(raster, quantity);
    if (!values) return tl::unexpected(values.error());
    const auto place = RasterPlace::of_dem(raster);
    if (!place) return tl::unexpected(place.error());
    GridChoice wanted = choice;
    if (choice.squares == GridChoice::kOwn) {
        if (std::abs(place->reach_x - place->reach_y) > 1e-6 * place->reach_x ||
            place->georeference.is_local())
            return tl::unexpected<std::string>(
                "its pixels are not square on the map, so no grid can have them; give --grid");
        wanted.squares = std::max(values->columns(), values->rows()) - 1;
    }
    const auto grid = grid_over(place->max_x - place->min_x, place->max_y - place->min_y, wanted);
    if (!grid) return tl::unexpected(grid.error());
    Terrain terrain;
    terrain.licence = licence_of(raster.get());
    terrain.grid = *grid;
    terrain.georeference = place->georeference;
    terrain.cover.assign(grid->size(), 0.f);
    if (auto filled = fill(*values, *place, terrain); !filled) return tl::unexpected(filled.error());
    return terrain;
}

}  // namespace

tl::expected<Terrain, std::string> read_dem(const std::filesystem::path& path, const GridChoice& choice,
                                            References references, Quantity quantity) {
    const GdalErrors errors;
    const auto raster = Raster::open(path, references);
    if (!raster) return tl::unexpected(raster.error());
    const auto named = [&path](const std::string& fact) {
        return fmt::format("{}: {}", path.string(), fact);
    };
    auto terrain = read(*raster, choice, quantity);
    if (!terrain) return tl::unexpected(named(terrain.error()));
    terrain->name = path.filename().string();
    terrain->files = raster->files();
    for (std::string& warning : terrain->warnings) warning = named(warning);
    return terrain;
}

tl::expected<void, std::string> set_system(const std::string& system, Terrain& terrain) {
    if (terrain.georeference.placed())
        return tl::unexpected<std::string>("it names a coordinate system already; leave out --crs");
    const GdalErrors errors;
    const double x = terrain.georeference.origin_x(), y = terrain.georeference.origin_y();
    auto placed = place_in(system, x, y, x + (terrain.grid.nx - 1) * static_cast<double>(terrain.grid.dx) / 2,
                           y + (terrain.grid.ny - 1) * static_cast<double>(terrain.grid.dx) / 2);
    if (!placed) return tl::unexpected(placed.error());
    terrain.georeference = std::move(*placed);
    return {};
}

}  // namespace terrains
