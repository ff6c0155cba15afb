#include "terrains/export.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <system_error>
#include <vector>

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <ogr_srs_api.h>

#include "files/whole_file.h"
#include "sim/check.h"
#include "terrains/gdal_support.h"
#include "terrains/outlines.h"

namespace terrains {
namespace {

constexpr float kNoData = -9999;

Written write_text(const std::filesystem::path& path, std::string_view text) {
    return files::write(path, text);
}

// A file in memory that GDAL writes by name: GDAL may write no other, and does not report every failed write.
class MemoryFile {
  public:
    MemoryFile() : name_(fmt::format("/vsimem/couloir/{}.tif", fmt::ptr(this))) {}
    ~MemoryFile() { VSIUnlink(name_.c_str()); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    const char* name() const { return name_.c_str(); }
    std::string_view bytes() const {
        vsi_l_offset size = 0;
        const GByte* bytes = VSIGetMemFileBuffer(name_.c_str(), &size, FALSE);
        return {reinterpret_cast<const char*>(bytes), bytes ? static_cast<std::size_t>(size) : 0};
    }

  private:
    std::string name_;
};

// The raster's rows as files have them: the north first, NaN as no data.
std::vector<float> north_first(const sim::Grid& grid, std::span<const float> field) {
    std::vector<float> rows;
    rows.reserve(field.size());
    for (int y = grid.ny - 1; y >= 0; --y)
        for (int x = 0; x < grid.nx; ++x) {
            const float value = field[static_cast<std::size_t>(y) * grid.nx + x];
            rows.push_back(std::isnan(value) ? kNoData : value);
        }
    return rows;
}

double west_edge(const sim::Grid& grid, const Georeference& place) {
    return place.origin_x() - 0.5 * grid.dx;
}
double south_edge(const sim::Grid& grid, const Georeference& place) {
    return place.origin_y() - 0.5 * grid.dx;
}

Written fill_geotiff(GDALDatasetH dataset, const sim::Grid& grid, const Georeference& place,
                     std::vector<float> rows) {
    const double dx = grid.dx;
    std::array<double, 6> pixels{
        west_edge(grid, place), dx, 0, south_edge(grid, place) + grid.ny * dx, 0, -dx};
    GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
    const GdalErrors errors;
    GDALSetGeoTransform(dataset, pixels.data());
    if (place.placed())
        if (const SpatialReference system = SpatialReference::from_wkt(place.wkt()))
            GDALSetSpatialRef(dataset, system.get());
    GDALSetRasterNoDataValue(band, kNoData);
    if (GDALRasterIO(band, GF_Write, 0, 0, grid.nx, grid.ny, rows.data(), grid.nx, grid.ny, GDT_Float32, 0,
                     0) != CE_None ||
        errors.any())
        return tl::unexpected(errors.first());
    return {};
}

// The dialect of WKT that readers of .prj files know.
std::string to_prj(const std::string& wkt) {
    const GdalErrors errors;
    const SpatialReference system = SpatialReference::from_wkt(wkt);
    std::array<const char*, 2> options{"FORMAT=WKT1_ESRI", nullptr};
    char* text = nullptr;
    std::string prj;
    if (system && OSRExportToWktEx(system.get(), &text, options.data()) == OGRERR_NONE && text != nullptr)
        prj = text;
    CPLFree(text);
    return prj;
}

}  // namespace

Written write_geotiff(const std::filesystem::path& path, const sim::Grid& grid,
                      const Georeference& georeference, std::span<const float> field) {
    CHECK(field.size() == grid.size());
    const MemoryFile file;
    const auto fill = [&]() -> Written {
        const GdalErrors errors;
        std::array<const char*, 3> options{"COMPRESS=DEFLATE", "PREDICTOR=3", nullptr};
        std::array<char*, 3> writable{};
        std::transform(options.begin(), options.end(), writable.begin(),
                       [](auto o) { return const_cast<char*>(o); });
        Dataset dataset(GDALCreate(GDALGetDriverByName("GTiff"), file.name(), grid.nx, grid.ny, 1,
                                   GDT_Float32, writable.data()));
        if (dataset == nullptr) return tl::unexpected(errors.first());
        if (auto filled = fill_geotiff(dataset.get(), grid, georeference, north_first(grid, field)); !filled)
            return filled;
        dataset.reset();  // much is written only now
        if (errors.any()) return tl::unexpected(errors.first());
        return {};
    };
    if (auto filled = fill(); !filled)
        return tl::unexpected(fmt::format("{}: cannot be written ({})", path.string(), filled.error()));
    return write_text(path, file.bytes());
}

Written write_ascii(const std::filesystem::path& path, const sim::Grid& grid,
                    const Georeference& georeference, std::span<const float> field) {
    CHECK(field.size() == grid.size());
    std::string text = fmt::format(
        "ncols {}\nnrows {}\nxllcorner {}\nyllcorner {}\ncellsize {}\nNODATA_value {}\n", grid.nx, grid.ny,
        west_edge(grid, georeference), south_edge(grid, georeference), static_cast<double>(grid.dx), kNoData);
    const std::vector<float> rows = north_first(grid, field);
    for (std::size_t i = 0; i < rows.size(); ++i)
        fmt::format_to(std::back_inserter(text), "{}{}", rows[i], (i + 1) % grid.nx == 0 ? '\n' : ' ');
    const std::filesystem::path prj = std::filesystem::path(path).replace_extension(".prj");
    if (georeference.placed()) {
        if (auto written = write_text(prj, to_prj(georeference.wkt())); !written) return written;
    } else {
        std::error_code absent;
        std::filesystem::remove(prj, absent);
    }
    return write_text(path, text);
}

Written write_outlines(const std::filesystem::path& path, const sim::Grid& grid,
                       const Georeference& georeference, std::span<const std::uint8_t> mask) {
    CHECK(mask.size() == grid.size());
    const auto text = outlines_of(grid, georeference, mask);
    if (!text) return tl::unexpected(fmt::format("{}: {}", path.string(), text.error()));
    return write_text(path, *text);
}

}  // namespace terrains
