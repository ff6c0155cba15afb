#include "terrains/raster_place.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <GeographicLib/Geodesic.hpp>

#include "terrains/raster_system.h"
#include "terrains/well_known_text.h"

namespace terrains {
namespace {

constexpr double kTrueScale = 0.005;  // largest scale error of a plane to simulate on
constexpr double kWidestDegrees = 2;  // within it a transverse Mercator plane is true to 0.02 %
constexpr double kLeastPixel = 1e-3, kMostPixel = 1e6;  // m
constexpr double kFarthest = 1e9;                       // m
constexpr double kWidestMetres = 250e3;                 // the limit for systems that are not in degrees

// Plane metres per true metre around a point, the worse of the two axes; 0 if the point is off the Earth.
double scale_at(const PlaneTransform& to_degrees, double x, double y) {
    constexpr double kStep = 500;  // m
    std::vector<double> east{x - kStep, x + kStep, x, x}, north{y, y, y - kStep, y + kStep};
    if (!to_degrees.apply(east, north)) return 0;
    double worst = 1;
    for (const int pair : {0, 2}) {
        double distance = 0;
        GeographicLib::Geodesic::WGS84().Inverse(north[pair], east[pair], north[pair + 1], east[pair + 1],
                                                 distance);
        const double scale = 2 * kStep / distance;
        if (std::abs(scale - 1) > std::abs(worst - 1)) worst = scale;
    }
    return worst;
}

}  // namespace

tl::expected<Georeference, std::string> place_in(const std::string& text, double x, double y, double middle_x,
                                                 double middle_y) {
    const auto system = read_system(text);
    if (!system)
        return tl::unexpected(fmt::format(
            "--crs '{}' is neither the code of a known system, such as EPSG:31287, nor WKT", text));
    if (!system->projected || system->metres_per_unit != 1)
        return tl::unexpected(
            fmt::format("--crs '{}' is no system in metres; put a .prj beside the file", text));
    if (system->metres_per_height != 1)
        return tl::unexpected(
            fmt::format("--crs '{}' has heights that are not in metres; put a .prj beside the file", text));
    const std::string& wkt = system->wkt;
    const auto to_degrees = PlaneTransform::between(wkt, wgs84_wkt());
    if (!to_degrees) return tl::unexpected(to_degrees.error());
    if (!(std::abs(scale_at(*to_degrees, middle_x, middle_y) - 1) <= kTrueScale))
        return tl::unexpected(
            fmt::format("--crs '{}' is not true to 0.5 % there; is it the file's system?", text));
    return Georeference::projected(wkt, x, y);
}

tl::expected<RasterPlace, std::string> RasterPlace::of_dem(const Raster& raster) {
    GDALDatasetH dataset = raster.get();
    RasterPlace place;
    place.columns_ = GDALGetRasterXSize(dataset);
    place.rows_ = GDALGetRasterYSize(dataset);
    auto& g = place.geotransform_;
    if (GDALGetGeoTransform(dataset, g.data()) != CE_None)
        return tl::unexpected<std::string>(
            "it has no geotransform; open a plain image as a heightmap, with a cell size and heights");
    const double area = g[1] * g[5] - g[2] * g[4];
    if (!std::isfinite(area) || area == 0 || !std::isfinite(g[0] + g[3]))
        return tl::unexpected<std::string>("its pixels have no size");
    const auto stated = system_of(raster);
    if (!stated) return tl::unexpected(stated.error());
    const RasterSystem& system = *stated;
    if (system.wkt.empty()) {
        if (auto kept = place.keep_axes(); !kept) return tl::unexpected(kept.error());
        place.georeference = Georeference::unnamed(place.min_x, place.min_y);
        return place;
    }
    bool keep = system.projected && system.metres_per_unit == 1 && !place.rotated();
    if (keep) {
        const auto to_degrees = PlaneTransform::between(system.wkt, wgs84_wkt());
        if (!to_degrees) return tl::unexpected(to_degrees.error());
        keep =
            std::abs(scale_at(*to_degrees, g[0] + g[1] * place.columns_ / 2, g[3] + g[5] * place.rows_ / 2) -
                     1) <= kTrueScale;
    }
    if (keep) {
        if (auto kept = place.keep_axes(); !kept) return tl::unexpected(kept.error());
        place.georeference = Georeference::projected(system.wkt, place.min_x, place.min_y);
        return place;
    }
    const double widest = std::max(std::abs(g[1]) * place.columns_, std::abs(g[5]) * place.rows_);
    if (system.geographic && widest > kWidestDegrees)
        return tl::unexpected(fmt::format("it spans {:.4g}°; the limit is {}°; crop it to the mountain",
                                          widest, kWidestDegrees));
    if (auto laid = place.lay_on_local_plane(system.wkt); !laid) return tl::unexpected(laid.error());
    return place;
}

tl::expected<void, std::string> RasterPlace::keep_axes() {
    const auto& g = geotransform_;
    if (rotated())
        return tl::unexpected<std::string>(
            "its rows are rotated against north and it names no coordinate system");
    const double west = g[0] + 0.5 * g[1], east = g[0] + (columns_ - 0.5) * g[1];
    const double north = g[3] + 0.5 * g[5], south = g[3] + (rows_ - 0.5) * g[5];
    min_x = std::min(west, east);
    max_x = std::max(west, east);
    min_y = std::min(north, south);
    max_y = std::max(north, south);
    reach_x = std::abs(g[1]);
    reach_y = std::abs(g[5]);
    pixel_area = reach_x * reach_y;
    if (reach_x < 0.01 && std::max(std::abs(west), std::abs(east)) <= 360 &&
        std::max(std::abs(north), std::abs(south)) <= 90)
        return tl::unexpected(
            fmt::format("its cells are {:.3g} wide, which looks like degrees, but it names no "
                        "coordinate system; put a .prj beside it",
                        reach_x));
    return check_lengths();
}

// Beyond these limits, floating-point precision cannot separate neighbouring pixels.
tl::expected<void, std::string> RasterPlace::check_lengths() const {
    for (const double reach : {reach_x, reach_y})
        if (!(reach >= kLeastPixel && reach <= kMostPixel))
            return tl::unexpected(fmt::format("its pixels are {:.3g} m by {:.3g} m, not {} to {} m", reach_x,
                                              reach_y, kLeastPixel, kMostPixel));
    if (!(pixel_area >= kLeastPixel * kLeastPixel))
        return tl::unexpected(fmt::format("its pixels are {:.3g} m2 large, not {} and more", pixel_area,
                                          kLeastPixel * kLeastPixel));
    for (const double side : {min_x, max_x, min_y, max_y})
        if (!(std::abs(side) <= kFarthest))
            return tl::unexpected(
                fmt::format("it lies {:.3g} m from the origin of its coordinates, not up to {:.0g} m",
                            std::abs(side), kFarthest));
    return {};
}

tl::expected<void, std::string> RasterPlace::lay_on_local_plane(const std::string& wkt) {
    auto to_degrees = PlaneTransform::between(wkt, wgs84_wkt());
    if (!to_degrees) return tl::unexpected(to_degrees.error());
    std::vector<double> x, y;
    centres({(columns_ - 1) / 2.0}, {(rows_ - 1) / 2.0}, x, y);
    if (!to_degrees->apply(x, y)) return tl::unexpected<std::string>("its middle has no position on Earth");
    const LatLon centre{y[0], x[0]};
    auto warp = PlaneTransform::between(wkt, local_plane_wkt(centre.latitude, centre.longitude));
    if (!warp) return tl::unexpected(warp.error());
    warp_ = std::move(*warp);
    measure_rectangle();
    if (!std::isfinite(max_x - min_x + max_y - min_y))
        return tl::unexpected<std::string>("some of its pixels have no position on Earth");
    if (std::max(max_x - min_x, max_y - min_y) > kWidestMetres)
        return tl::unexpected(fmt::format("it spans {:.0f} km; the limit is {:.0f} km",
                                          std::max(max_x - min_x, max_y - min_y) / 1e3, kWidestMetres / 1e3));
    measure_pixels();
    georeference = Georeference::local(centre, min_x, min_y);
    return check_lengths();
}

// The largest rectangle inside a slightly warped border. For rotated rows it is the bounding rectangle, whose
// corners then have no data.
void RasterPlace::measure_rectangle() {
    std::vector<double> along_columns(columns_), along_rows(rows_), x, y;
    for (int i = 0; i < columns_; ++i) along_columns[i] = i;
    for (int j = 0; j < rows_; ++j) along_rows[j] = j;
    struct Range {
        double low, high;
    };
    const auto side = [&](const std::vector<double>& columns, const std::vector<double>& rows, bool of_x) {
        centres(columns, rows, x, y);
        project(x, y);
        const auto [low, high] = std::minmax_element((of_x ? x : y).begin(), (of_x ? x : y).end());
        return std::isfinite(*low + *high) ? Range{*low, *high} : Range{std::nan(""), std::nan("")};
    };
    const auto between = [](Range a, Range b, double& low, double& high) {
        if (a.low > b.low) std::swap(a, b);
        const double outer = std::max(a.high, b.high) - std::min(a.low, b.low);
        const bool slight = b.low - a.high > 0.9 * outer;
        low = slight ? a.high : std::min(a.low, b.low);
        high = slight ? b.low : std::max(a.high, b.high);
        return slight;
    };
    const double last_column = columns_ - 1, last_row = rows_ - 1;
    const Range first_side = side(std::vector<double>(rows_, 0.0), along_rows, true);
    const Range last_side = side(std::vector<double>(rows_, last_column), along_rows, true);
    const Range top = side(along_columns, std::vector<double>(columns_, 0.0), false);
    const Range bottom = side(along_columns, std::vector<double>(columns_, last_row), false);
    between(first_side, last_side, min_x, max_x);
    between(top, bottom, min_y, max_y);
    if (std::isnan(first_side.low + last_side.low + top.low + bottom.low)) max_x = std::nan("");
}

void RasterPlace::measure_pixels() {
    const double c = columns_ - 2, r = rows_ - 2;
    for (const auto& [column, row] : {std::pair{0.0, 0.0}, {c, 0.0}, {0.0, r}, {c, r}, {c / 2, r / 2}}) {
        std::vector<double> x, y;
        centres({column, column + 1, column}, {row, row, row + 1}, x, y);
        project(x, y);
        // Slightly more than the spacing, so that no vertex on one column of a warped raster misses the next.
        reach_x = std::max(reach_x, 1.02 * (std::abs(x[1] - x[0]) + std::abs(x[2] - x[0])));
        reach_y = std::max(reach_y, 1.02 * (std::abs(y[1] - y[0]) + std::abs(y[2] - y[0])));
        pixel_area = std::abs((x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]));
    }
}

bool RasterPlace::project(std::vector<double>& x, std::vector<double>& y) const {
    return !warp_ || warp_->apply(x, y);
}

void RasterPlace::centres(const std::vector<double>& columns, const std::vector<double>& rows,
                          std::vector<double>& x, std::vector<double>& y) const {
    const auto& g = geotransform_;
    x.resize(columns.size());
    y.resize(columns.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
        x[i] = g[0] + (columns[i] + 0.5) * g[1] + (rows[i] + 0.5) * g[2];
        y[i] = g[3] + (columns[i] + 0.5) * g[4] + (rows[i] + 0.5) * g[5];
    }
}

void RasterPlace::places(const std::vector<double>& columns, double row, std::vector<double>& x,
                         std::vector<double>& y) const {
    centres(columns, std::vector<double>(columns.size(), row), x, y);
    project(x, y);
}

void RasterPlace::positions(int row, std::vector<double>& x, std::vector<double>& y) const {
    const int stride = warp_ ? 8 : 1;
    std::vector<double> columns;
    for (int column = 0; column < columns_ - 1; column += stride) columns.push_back(column);
    columns.push_back(columns_ - 1);
    std::vector<double> knots_x, knots_y;
    places(columns, row, knots_x, knots_y);
    x.resize(columns_);
    y.resize(columns_);
    for (std::size_t k = 0; k + 1 < columns.size(); ++k) {
        const int first = static_cast<int>(columns[k]), last = static_cast<int>(columns[k + 1]);
        for (int i = first; i <= last; ++i) {
            const double t = static_cast<double>(i - first) / (last - first);
            x[i] = (1 - t) * knots_x[k] + t * knots_x[k + 1];
            y[i] = (1 - t) * knots_y[k] + t * knots_y[k + 1];
        }
    }
}

}  // namespace terrains
