#include "terrains/depth_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "terrains/gdal_support.h"
#include "terrains/limits.h"
#include "terrains/plane_transform.h"
#include "terrains/raster_place.h"

namespace terrains {
namespace {

constexpr double kDeepest = 200;  // m

struct Depths {
    int columns = 0, rows = 0;
    std::vector<float> metres;  // row 0 first in the file
    std::array<double, 6> to_pixels{};
    std::string wkt;
};

// How a raster's values are read: as amounts of either sign, or as signed changes, up or down.
enum class Meaning { kAmount, kSigned };

tl::expected<void, std::string> read_values(GDALDatasetH dataset, Meaning meaning, Depths& depths) {
    const GdalErrors errors;
    GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
    const std::size_t count = static_cast<std::size_t>(depths.columns) * depths.rows;
    depths.metres.resize(count);
    std::vector<std::uint8_t> known(count);
    const bool done = GDALRasterIO(band, GF_Read, 0, 0, depths.columns, depths.rows, depths.metres.data(),
                                   depths.columns, depths.rows, GDT_Float32, 0, 0) == CE_None &&
                      GDALRasterIO(GDALGetMaskBand(band), GF_Read, 0, 0, depths.columns, depths.rows,
                                   known.data(), depths.columns, depths.rows, GDT_Byte, 0, 0) == CE_None;
    if (!done || errors.any())
        return tl::unexpected(fmt::format("damaged or cut short ({})", errors.first()));
    bool raised = false, lowered = false;
    for (std::size_t i = 0; i < count; ++i) {
        float& depth = depths.metres[i];
        if (known[i] == 0 || std::isnan(depth) || depth == -9999.f || depth == -32768.f) depth = 0;
        if (!(std::abs(depth) <= kDeepest))
            return tl::unexpected(fmt::format("row {}, column {} is {} m deep; the limit is {} m",
                                              i / depths.columns + 1, i % depths.columns + 1, depth,
                                              kDeepest));
        raised = raised || depth > 0;
        lowered = lowered || depth < 0;
        if (meaning == Meaning::kAmount) depth = std::abs(depth);
    }
    if (meaning == Meaning::kAmount && raised && lowered)
        return tl::unexpected<std::string>(
            "it has depths of both signs, so the release is ambiguous; use one sign");
    return {};
}

tl::expected<Depths, std::string> read(GDALDatasetH dataset, Meaning meaning) {
    if (auto bounded = check_size(dataset); !bounded) return tl::unexpected(bounded.error());
    Depths depths;
    depths.columns = GDALGetRasterXSize(dataset);
    depths.rows = GDALGetRasterYSize(dataset);
    if (static_cast<std::uint64_t>(depths.columns) * static_cast<std::uint64_t>(depths.rows) >
        kMostDepthPixels)
        return tl::unexpected(fmt::format("over {} million pixels, the limit for a depth raster",
                                          kMostDepthPixels / 1'000'000));
    std::array<double, 6> from_pixels{};
    if (GDALGetGeoTransform(dataset, from_pixels.data()) != CE_None ||
        GDALInvGeoTransform(from_pixels.data(), depths.to_pixels.data()) == 0)
        return tl::unexpected<std::string>("it has no geotransform, so its position is unknown");
    depths.wkt = system_of(dataset).wkt;
    if (auto values = read_values(dataset, meaning, depths); !values) return tl::unexpected(values.error());
    return depths;
}

// The transform from the terrain's plane to the raster's system; none if both are the same.
tl::expected<std::optional<PlaneTransform>, std::string> between(const Georeference& ground,
                                                                 const Depths& depths) {
    if (!ground.has_coordinates())
        return tl::unexpected<std::string>(
            "the terrain has no coordinates, so no raster can be placed on it");
    if (depths.wkt.empty() && ground.is_local())
        return tl::unexpected<std::string>(
            "it has no coordinate system, and the terrain uses a local plane; add a .prj");
    if (depths.wkt.empty()) return std::nullopt;
    if (!ground.placed())
        return tl::unexpected<std::string>(
            "it has a coordinate system but the terrain has none, so they cannot be aligned");
    if (depths.wkt == ground.wkt()) return std::nullopt;
    auto transform = PlaneTransform::between(ground.wkt(), depths.wkt);
    if (!transform) return tl::unexpected(transform.error());
    return std::optional<PlaneTransform>(std::move(*transform));
}

// One row of cell corners, in pixels, from the first cell's south-west corner to the last cell's south-east
// corner.
struct Corners {
    std::vector<double> column, row;
};

Corners corners_below(int y, const Terrain& terrain, const Depths& depths,
                      const std::optional<PlaneTransform>& way) {
    Corners corners;
    const double dx = terrain.grid.dx;
    for (int i = 0; i <= terrain.grid.nx; ++i) {
        corners.column.push_back(terrain.georeference.origin_x() + (i - 0.5) * dx);
        corners.row.push_back(terrain.georeference.origin_y() + (y - 0.5) * dx);
    }
    if (way) way->apply(corners.column, corners.row);
    const auto& g = depths.to_pixels;
    for (std::size_t i = 0; i < corners.row.size(); ++i) {
        const double x = corners.column[i], y_there = corners.row[i];
        corners.column[i] = g[0] + g[1] * x + g[2] * y_there;
        corners.row[i] = g[3] + g[4] * x + g[5] * y_there;
    }
    return corners;
}

// Depth at a position in pixels, bilinear between pixel centres and 0 beyond the raster. Its integral is the
// sum of each pixel's depth times area. 0 at NaN, where a corner cannot be expressed.
double depth_at(const Depths& depths, double column, double row) {
    const double left = std::floor(column - 0.5), low = std::floor(row - 0.5);
    double sum = 0;
    for (const int j : {0, 1})
        for (const int i : {0, 1}) {
            const double c = left + i, r = low + j;
            if (!(c >= 0 && r >= 0 && c < depths.columns && r < depths.rows)) continue;
            const double weight = (1 - std::abs(column - 0.5 - c)) * (1 - std::abs(row - 0.5 - r));
            sum += weight *
                   depths.metres[static_cast<std::size_t>(r) * depths.columns + static_cast<std::size_t>(c)];
        }
    return sum;
}

// Mean over a cell with corners in pixels: samples² evenly spaced points.
float mean_depth(const Depths& depths, const Corners& below, const Corners& above, int x, int samples) {
    const auto blend = [&](const std::vector<double>& low, const std::vector<double>& high, double s,
                           double t) {
        return (1 - t) * ((1 - s) * low[x] + s * low[x + 1]) + t * ((1 - s) * high[x] + s * high[x + 1]);
    };
    double sum = 0;
    for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i) {
            const double s = (i + 0.5) / samples, t = (j + 0.5) / samples;
            sum +=
                depth_at(depths, blend(below.column, above.column, s, t), blend(below.row, above.row, s, t));
        }
    return static_cast<float>(sum / (samples * samples));
}

tl::expected<std::vector<float>, std::string> read(GDALDatasetH dataset, Meaning meaning,
                                                   const Terrain& terrain) {
    const auto depths = read(dataset, meaning);
    if (!depths) return tl::unexpected(depths.error());
    const auto way = between(terrain.georeference, *depths);
    if (!way) return tl::unexpected(way.error());
    std::vector<float> thickness;
    thickness.reserve(terrain.grid.size());
    Corners below = corners_below(0, terrain, *depths, *way);
    // Three samples across a pixel, at least four across a cell.
    const double across = std::hypot(below.column[1] - below.column[0], below.row[1] - below.row[0]);
    const int samples =
        static_cast<int>(std::clamp(std::isfinite(across) ? std::ceil(3 * across) : 4.0, 4.0, 64.0));
    for (int y = 0; y < terrain.grid.ny; ++y) {
        Corners above = corners_below(y + 1, terrain, *depths, *way);
        for (int x = 0; x < terrain.grid.nx; ++x)
            thickness.push_back(mean_depth(*depths, below, above, x, samples));
        below = std::move(above);
    }
    return thickness;
}

tl::expected<std::vector<float>, std::string> read(const std::filesystem::path& path, Meaning meaning,
                                                   const Terrain& terrain, References references,
                                                   std::vector<std::filesystem::path>* files) {
    const GdalErrors errors;
    const auto dataset = Raster::open(path, references);
    if (!dataset) return tl::unexpected(dataset.error());
    auto values = read(dataset->get(), meaning, terrain);
    if (!values) return tl::unexpected(fmt::format("{}: {}", path.string(), values.error()));
    if (files != nullptr) *files = dataset->files();
    return values;
}

}  // namespace

tl::expected<std::vector<float>, std::string> read_depth_raster(const std::filesystem::path& path,
                                                                const Terrain& terrain, References references,
                                                                std::vector<std::filesystem::path>* files) {
    return read(path, Meaning::kAmount, terrain, references, files);
}

tl::expected<std::vector<float>, std::string> read_signed_raster(const std::filesystem::path& path,
                                                                 const Terrain& terrain,
                                                                 References references,
                                                                 std::vector<std::filesystem::path>* files) {
    return read(path, Meaning::kSigned, terrain, references, files);
}

}  // namespace terrains
