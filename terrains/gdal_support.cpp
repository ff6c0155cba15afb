#include "terrains/gdal_support.h"

#include <algorithm>
#include <string>

#include <cpl_error.h>
#include <fmt/format.h>
#include <ogr_srs_api.h>

namespace terrains {
namespace {

void CPL_STDCALL keep_first_failure(CPLErr severity, CPLErrorNum, const char* message) {
    auto* first = static_cast<std::string*>(CPLGetErrorHandlerUserData());
    if (severity < CE_Failure || !first->empty()) return;
    *first = message;
    std::replace(first->begin(), first->end(), '\n', ' ');
}

}  // namespace

GdalErrors::GdalErrors() {
    [[maybe_unused]] static const bool registered = (GDALAllRegister(), true);
    CPLPushErrorHandlerEx(keep_first_failure, &first_);
}

GdalErrors::~GdalErrors() {
    CPLPopErrorHandler();
}

std::string GdalErrors::first() const {
    return first_.empty() ? "no reason given" : first_;
}

tl::expected<Dataset, std::string> open_raster(const std::filesystem::path& path) {
    const GdalErrors errors;
    std::error_code status;
    if (!std::filesystem::exists(path, status))
        return tl::unexpected(fmt::format("{}: there is no such file", path.string()));
    Dataset dataset(GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                               nullptr, nullptr, nullptr));
    if (dataset == nullptr || GDALGetRasterCount(dataset.get()) < 1)
        return tl::unexpected(
            fmt::format("{}: not a raster that can be read ({})", path.string(), errors.first()));
    return dataset;
}

void SpatialReference::Destroy::operator()(void* handle) const {
    OSRDestroySpatialReference(handle);
}

SpatialReference SpatialReference::from_wkt(const std::string& wkt) {
    SpatialReference made(OSRNewSpatialReference(nullptr));
    if (OSRSetFromUserInput(made.get(), wkt.c_str()) != OGRERR_NONE) return SpatialReference(nullptr);
    OSRSetAxisMappingStrategy(made.get(), OAMS_TRADITIONAL_GIS_ORDER);
    return made;
}

}  // namespace terrains
