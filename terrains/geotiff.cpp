#include "terrains/geotiff.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <ogr_srs_api.h>

#include "terrains/gdal_support.h"

namespace terrains {
namespace {

// A named file in memory, the only kind that GDAL may write (gdal_files.h).
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

tl::expected<void, std::string> fill(GDALDatasetH dataset, const sim::Grid& grid, const Georeference& place,
                                     std::span<const float> rows) {
    const double dx = grid.dx;
    std::array<double, 6> pixels{
        west_edge(grid, place), dx, 0, south_edge(grid, place) + grid.ny * dx, 0, -dx};
    GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
    const GdalErrors errors;
    GDALSetGeoTransform(dataset, pixels.data());
    if (place.placed())
        if (const SpatialReference system = SpatialReference::from_wkt(place.wkt()))
            GDALSetSpatialRef(dataset, system.get());
    GDALSetRasterNoDataValue(band, kNoDataWritten);
    if (GDALRasterIO(band, GF_Write, 0, 0, grid.nx, grid.ny, const_cast<float*>(rows.data()), grid.nx,
                     grid.ny, GDT_Float32, 0, 0) != CE_None ||
        errors.any())
        return tl::unexpected(errors.first());
    return {};
}

}  // namespace

tl::expected<std::string, std::string> encode_geotiff(const sim::Grid& grid, const Georeference& place,
                                                      std::span<const float> rows) {
    const GdalErrors errors;
    const MemoryFile file;
    std::array<const char*, 3> options{"COMPRESS=DEFLATE", "PREDICTOR=3", nullptr};
    std::array<char*, 3> writable{};
    std::transform(options.begin(), options.end(), writable.begin(),
                   [](auto o) { return const_cast<char*>(o); });
    Dataset dataset(GDALCreate(GDALGetDriverByName("GTiff"), file.name(), grid.nx, grid.ny, 1, GDT_Float32,
                               writable.data()));
    if (dataset == nullptr) return tl::unexpected(errors.first());
    if (auto filled = fill(dataset.get(), grid, place, rows); !filled) return tl::unexpected(filled.error());
    dataset.reset();  // writes most of the file
    if (errors.any()) return tl::unexpected(errors.first());
    return std::string(file.bytes());
}

std::string esri_wkt(const std::string& wkt) {
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

}  // namespace terrains
