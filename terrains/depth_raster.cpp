#include "terrains/depth_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "terrains/gdal_support.h"
#include "terrains/plane_transform.h"
#include "terrains/raster_system.h"
#include "terrains/raster_values.h"

namespace terrains {
namespace {

struct Depths {
    int columns = 0, rows = 0;
    std::vector<float> metres;  // row 0 first in the file
    std::array<double, 6> to_pixels{}, from_pixels{};
    std::string wkt;
};

// How a raster's values are read: as amounts of either sign, or as signed changes, up or down.
enum class Meaning { kAmount, kSigned };

tl::expected<void, std::string> read_values(RasterValues& values, Meaning meaning, Depths& depths) {
    const std::size_t columns = static_cast<std::size_t>(values.columns());
    depths.columns = values.columns();
    depths.rows = values.rows();
    depths.metres.reserve(columns * static_cast<std::size_t>(values.rows()));
    bool raised = false, lowered = false;
    std::vector<double> row;
    for (int i = 0; i < values.rows(); ++i) {
        if (auto read = values.read(i, row); !read) return read;
        for (const double metres : row) {
            const float depth = std::isnan(metres) ? 0.f : static_cast<float>(metres);
            raised = raised || depth > 0;
            lowered = lowered || depth < 0;
            depths.metres.push_back(meaning == Meaning::kAmount ? std::abs(depth) : depth);
        }
    }
    if (meaning == Meaning::kAmount && raised && lowered)
        return tl::unexpected<std::string>(
            "it has depths of both signs, so the release is ambiguous; use one sign");
    return {};
}

tl::expected<Depths, std::string> read(const Raster& raster, Meaning meaning) {
    auto values = RasterValues::open(raster, Quantity::kDepth);
    if (!values) return tl::unexpected(values.error());
    Depths depths;
    if (GDALGetGeoTransform(raster.get(), depths.from_pixels.data()) != CE_None ||
        GDALInvGeoTransform(depths.from_pixels.data(), depths.to_pixels.data()) == 0)
        return tl::unexpected<std::string>("it has no geotransform, so its position is unknown");
    const auto system = system_of(raster);
    if (!system) return tl::unexpected(system.error());
    depths.wkt = system->wkt;
    if (auto read = read_values(*values, meaning, depths); !read) return tl::unexpected(read.error());
    return depths;
}

// The ways between the terrain's plane and the raster's system; none if both are the same.
struct Ways {
    std::optional<PlaneTransform> to_raster, to_ground;
};

tl::expected<Ways, std::string> between(const Georeference& ground, const Depths& depths) {
    if (!ground.has_coordinates())
        return tl::unexpected<std::string>(
            "the terrain has no coordinates, so no raster can be placed on it");
    if (depths.wkt.empty() && ground.is_local())
        return tl::unexpected<std::string>(
            "it has no coordinate system, and the terrain uses a local plane; add a .prj");
    if (depths.wkt.empty()) return Ways();
    if (!ground.placed())
        return tl::unexpected<std::string>(
            "it has a coordinate system but the terrain has none, so they cannot be aligned");
    if (depths.wkt == ground.wkt()) return Ways();
    auto to_raster = PlaneTransform::between(ground.wkt(), depths.wkt);
    if (!to_raster) return tl::unexpected(to_raster.error());
    auto to_ground = PlaneTransform::between(depths.wkt, ground.wkt());
    if (!to_ground) return tl::unexpected(to_ground.error());
    return Ways{std::move(*to_raster), std::move(*to_ground)};
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

std::vector<float> mean_depths(const Depths& depths, const Terrain& terrain,
                               const std::optional<PlaneTransform>& way) {
    std::vector<float> mean;
    mean.reserve(terrain.grid.size());
    Corners below = corners_below(0, terrain, depths, way);
    // Three samples across a pixel, at least four across a cell.
    const double across = std::hypot(below.column[1] - below.column[0], below.row[1] - below.row[0]);
    const int samples =
        static_cast<int>(std::clamp(std::isfinite(across) ? std::ceil(3 * across) : 4.0, 4.0, 64.0));
    for (int y = 0; y < terrain.grid.ny; ++y) {
        Corners above = corners_below(y + 1, terrain, depths, way);
        for (int x = 0; x < terrain.grid.nx; ++x)
            mean.push_back(mean_depth(depths, below, above, x, samples));
        below = std::move(above);
    }
    return mean;
}

// Positions and areas of some pixels of one row on the terrain's plane.
struct Knots {
    std::vector<double> column, x, y, area;
};

constexpr int kStride = 16;

// Of every kStride-th pixel from `first` to `last`; between them all is linear enough.
Knots knots_of(const Depths& depths, int row, int first, int last, const std::optional<PlaneTransform>& way) {
    Knots knots;
    for (int column = first; column < last; column += kStride) knots.column.push_back(column);
    knots.column.push_back(last);
    const std::size_t count = knots.column.size();
    // Three points of each pixel: its centre, and a pixel farther along columns and rows.
    std::vector<double> x(3 * count), y(3 * count);
    const auto& g = depths.from_pixels;
    for (std::size_t k = 0; k < count; ++k)
        for (const int point : {0, 1, 2}) {
            const double c = knots.column[k] + 0.5 + (point == 1 ? 1 : 0),
                         r = row + 0.5 + (point == 2 ? 1 : 0);
            x[3 * k + static_cast<std::size_t>(point)] = g[0] + c * g[1] + r * g[2];
            y[3 * k + static_cast<std::size_t>(point)] = g[3] + c * g[4] + r * g[5];
        }
    if (way) way->apply(x, y);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = 3 * k;
        knots.x.push_back(x[i]);
        knots.y.push_back(y[i]);
        knots.area.push_back(
            std::abs((x[i + 1] - x[i]) * (y[i + 2] - y[i]) - (x[i + 2] - x[i]) * (y[i + 1] - y[i])));
    }
    return knots;
}

// The volume of a whole raster.
struct FileVolume {
    double m3 = 0;             // of amounts without sign, each pixel with its area on the plane
    bool near_border = false;  // a pixel with a depth lies not within the grid's cells by its own width
};

void add_row(const Depths& depths, int row, const Terrain& terrain, const std::optional<PlaneTransform>& way,
             FileVolume& volume) {
    const float* values =
        depths.metres.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(depths.columns);
    int first = 0, last = depths.columns - 1;
    while (first <= last && values[first] == 0) ++first;
    while (last > first && values[last] == 0) --last;
    if (first > last) return;
    const Knots knots = knots_of(depths, row, first, last, way);
    const double dx = static_cast<double>(terrain.grid.dx);
    const double west = terrain.georeference.origin_x() - dx / 2,
                 south = terrain.georeference.origin_y() - dx / 2;
    const double east = west + terrain.grid.nx * dx, north = south + terrain.grid.ny * dx;
    for (int column = first; column <= last; ++column) {
        if (values[column] == 0) continue;
        const auto k = static_cast<std::size_t>((column - first) / kStride);
        const std::size_t next = std::min(k + 1, knots.column.size() - 1);
        const double step = knots.column[next] - knots.column[k];
        const double t = step > 0 ? (column - knots.column[k]) / step : 0;
        const auto at = [&](const std::vector<double>& of) { return (1 - t) * of[k] + t * of[next]; };
        const double x = at(knots.x), y = at(knots.y), area = at(knots.area), width = std::sqrt(area);
        if (!(x - width >= west && x + width <= east && y - width >= south && y + width <= north))
            volume.near_border = true;
        if (std::isfinite(area)) volume.m3 += std::abs(static_cast<double>(values[column])) * area;
    }
}

double volume_on_grid(const std::vector<float>& mean, const Terrain& terrain) {
    const double dx = static_cast<double>(terrain.grid.dx);
    double sum = 0;
    for (const float depth : mean) sum += std::abs(static_cast<double>(depth));
    return sum * dx * dx;
}

tl::expected<DepthRaster, std::string> read(const std::filesystem::path& path, Meaning meaning,
                                            const Terrain& terrain, References references) {
    const GdalErrors errors;
    const auto raster = Raster::open(path, references);
    if (!raster) return tl::unexpected(raster.error());
    const auto bad = [&path](const std::string& fact) {
        return tl::unexpected(fmt::format("{}: {}", path.string(), fact));
    };
    const auto depths = read(*raster, meaning);
    if (!depths) return bad(depths.error());
    const auto ways = between(terrain.georeference, *depths);
    if (!ways) return bad(ways.error());
    DepthRaster result;
    result.mean = mean_depths(*depths, terrain, ways->to_raster);
    FileVolume volume;
    for (int row = 0; row < depths->rows; ++row) add_row(*depths, row, terrain, ways->to_ground, volume);
    result.in_file = volume.m3;
    // Otherwise the two differ by the samples of the cells only.
    if (volume.near_border) result.outside = std::max(volume.m3 - volume_on_grid(result.mean, terrain), 0.0);
    result.files = raster->files();
    return result;
}

}  // namespace

tl::expected<DepthRaster, std::string> read_depth_raster(const std::filesystem::path& path,
                                                         const Terrain& terrain, References references) {
    return read(path, Meaning::kAmount, terrain, references);
}

tl::expected<DepthRaster, std::string> read_signed_raster(const std::filesystem::path& path,
                                                          const Terrain& terrain, References references) {
    return read(path, Meaning::kSigned, terrain, references);
}

}  // namespace terrains
