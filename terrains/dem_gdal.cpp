#include "terrains/dem_gdal.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "terrains/gdal_support.h"
#include "terrains/pixel_blocks.h"
#include "terrains/raster_place.h"
#include "terrains/resample.h"

namespace terrains {
namespace {

constexpr double kLowest = -12'000, kHighest = 9'000;  // m: below every trench and above every summit

// Reads one row of heights at a time, in metres, NaN for no data.
class HeightRows {
  public:
    static tl::expected<HeightRows, std::string> open(GDALDatasetH dataset);

    // Fails on damage or an impossible height.
    tl::expected<void, std::string> read(int row, std::vector<double>& heights);

  private:
    GDALRasterBandH band_ = nullptr, mask_ = nullptr;  // mask_: null if every pixel counts
    double scale_ = 1, offset_ = 0;
    std::vector<std::uint8_t> known_;
};

tl::expected<double, std::string> metres_per_unit(const std::string& unit) {
    constexpr double kFoot = 0.3048, kSurveyFoot = 1200.0 / 3937.0;
    for (const char* metre : {"", "m", "metre", "metres", "meter", "meters", "Metre", "Meter"})
        if (unit == metre) return 1.0;
    for (const char* foot : {"ft", "foot", "feet", "Foot"})
        if (unit == foot) return kFoot;
    for (const char* foot : {"US survey foot", "us-ft", "ftUS", "sft", "Foot_US"})
        if (unit == foot) return kSurveyFoot;
    return tl::unexpected(fmt::format("its heights are in '{}', which is neither metres nor feet", unit));
}

tl::expected<HeightRows, std::string> HeightRows::open(GDALDatasetH dataset) {
    HeightRows rows;
    rows.band_ = GDALGetRasterBand(dataset, 1);
    if ((GDALGetMaskFlags(rows.band_) & GMF_ALL_VALID) == 0) rows.mask_ = GDALGetMaskBand(rows.band_);
    if (GDALDataTypeIsComplex(GDALGetRasterDataType(rows.band_)) != 0)
        return tl::unexpected<std::string>("its values are complex numbers, not heights");
    const auto unit = metres_per_unit(GDALGetRasterUnitType(rows.band_));
    if (!unit) return tl::unexpected(unit.error());
    rows.scale_ = GDALGetRasterScale(rows.band_, nullptr) * *unit;
    rows.offset_ = GDALGetRasterOffset(rows.band_, nullptr) * *unit;
    rows.known_.resize(static_cast<std::size_t>(GDALGetRasterXSize(dataset)), 255);
    return rows;
}

tl::expected<void, std::string> HeightRows::read(int row, std::vector<double>& heights) {
    const GdalErrors errors;
    const int width = static_cast<int>(known_.size());
    heights.resize(known_.size());
    const bool done = GDALRasterIO(band_, GF_Read, 0, row, width, 1, heights.data(), width, 1, GDT_Float64, 0,
                                   0) == CE_None &&
                      (mask_ == nullptr || GDALRasterIO(mask_, GF_Read, 0, row, width, 1, known_.data(),
                                                        width, 1, GDT_Byte, 0, 0) == CE_None);
    if (!done || errors.any())
        return tl::unexpected(fmt::format("damaged or cut short at row {} ({})", row + 1, errors.first()));
    for (int column = 0; column < width; ++column) {
        double& height = heights[column];
        if (known_[column] == 0 || height == -9999 || height == -32768 || std::isnan(height)) {
            height = std::nan("");
            continue;
        }
        const double raw = height;
        height = raw * scale_ + offset_;
        if (!(height >= kLowest && height <= kHighest))
            return tl::unexpected(fmt::format("row {}, column {} is {} m high; heights must be {} to {} m",
                                              row + 1, column + 1, height, kLowest, kHighest));
    }
    return {};
}

// GDAL accepts an ESRI ASCII grid whose last number is missing, and one with too many numbers. With a wrong
// ncols every row would be shifted, so the numbers are counted.
tl::expected<void, std::string> check_ascii_count(GDALDatasetH dataset, const std::filesystem::path& path) {
    if (std::string(GDALGetDriverShortName(GDALGetDatasetDriver(dataset))) != "AAIGrid") return {};
    const auto promised =
        static_cast<std::uint64_t>(GDALGetRasterXSize(dataset)) * GDALGetRasterYSize(dataset);
    std::ifstream file(path, std::ios::binary);
    std::uint64_t found = 0;
    std::string token;
    bool header = true;
    while (file >> token) {
        const bool key = header && std::isalpha(static_cast<unsigned char>(token[0])) != 0 &&
                         token != "nan" && token != "inf";
        if (key)
            file >> token;  // its value
        else
            ++found, header = false;
    }
    if (found == promised) return {};
    return tl::unexpected(
        fmt::format("damaged or cut short: it has {} heights where its header promises {}", found, promised));
}

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
tl::expected<void, std::string> fill(GDALDatasetH dataset, const RasterPlace& place, Terrain& terrain) {
    constexpr double kFinest = 16;  // pixels resolved along a cell
    auto rows = HeightRows::open(dataset);
    if (!rows) return tl::unexpected(rows.error());
    const double dx = terrain.grid.dx;
    PlaneFit fit(terrain.grid, std::max(dx, place.reach_x), std::max(dx, place.reach_y), place.pixel_area);
    const int columns = GDALGetRasterXSize(dataset), row_count = GDALGetRasterYSize(dataset);
    const int side = static_cast<int>(dx / (kFinest * std::max(place.reach_x, place.reach_y)));
    std::optional<PixelBlocks> blocks;
    if (side > 1) blocks.emplace(place, columns, row_count, side, fit);
    std::vector<double> heights;
    for (int row = 0; row < row_count; ++row) {
        if (auto read = rows->read(row, heights); !read) return read;
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
    return {};
}

tl::expected<Terrain, std::string> read(GDALDatasetH dataset, const std::filesystem::path& path,
                                        const GridChoice& choice) {
    if (auto bounded = check_size(dataset); !bounded) return tl::unexpected(bounded.error());
    if (auto whole = check_ascii_count(dataset, path); !whole) return tl::unexpected(whole.error());
    const auto place = RasterPlace::of_dem(dataset);
    if (!place) return tl::unexpected(place.error());
    GridChoice wanted = choice;
    if (choice.squares == GridChoice::kOwn) {
        if (std::abs(place->reach_x - place->reach_y) > 1e-6 * place->reach_x ||
            place->georeference.is_local())
            return tl::unexpected<std::string>(
                "its pixels are not square on the map, so no grid can have them; give --grid");
        wanted.squares = std::max(GDALGetRasterXSize(dataset), GDALGetRasterYSize(dataset)) - 1;
    }
    const auto grid = grid_over(place->max_x - place->min_x, place->max_y - place->min_y, wanted);
    if (!grid) return tl::unexpected(grid.error());
    Terrain terrain;
    terrain.licence = licence_of(dataset);
    terrain.grid = *grid;
    terrain.georeference = place->georeference;
    terrain.cover.assign(grid->size(), 0.f);
    if (auto filled = fill(dataset, *place, terrain); !filled) return tl::unexpected(filled.error());
    return terrain;
}

}  // namespace

tl::expected<Terrain, std::string> read_dem(const std::filesystem::path& path, const GridChoice& choice,
                                            References references) {
    const GdalErrors errors;
    const auto dataset = Raster::open(path, references);
    if (!dataset) return tl::unexpected(dataset.error());
    auto terrain = read(dataset->get(), path, choice);
    if (!terrain) return tl::unexpected(fmt::format("{}: {}", path.string(), terrain.error()));
    terrain->name = path.filename().string();
    terrain->files = dataset->files();
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
