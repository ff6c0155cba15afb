#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <gdal.h>
#include <tl/expected.hpp>

// What every reader and writer here needs of GDAL. Include it from sources only, never from a header of a
// format: GDAL's names stay in this folder's .cpp files.
namespace terrains {

// While one lives, GDAL and PROJ print nothing on this thread; what they would have printed is kept. Nests.
// Registers GDAL's drivers on first use.
class GdalErrors {
  public:
    GdalErrors();
    ~GdalErrors();
    GdalErrors(const GdalErrors&) = delete;
    GdalErrors& operator=(const GdalErrors&) = delete;

    bool any() const { return !first_.empty(); }
    // First failure in GDAL's words, on one line; "no reason given" where there was none.
    std::string first() const;
    void forget() { first_.clear(); }

  private:
    // Its address is GDAL's for as long as this lives, and GDAL writes to it whatever we promise.
    mutable std::string first_;
};

struct CloseDataset {
    void operator()(void* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, CloseDataset>;

// Opens a raster for reading. Errors: missing, not a raster, damaged; one sentence that names the file.
tl::expected<Dataset, std::string> open_raster(const std::filesystem::path& path);

// A coordinate system with x east-like and y north-like. Empty where the WKT could not be read.
class SpatialReference {
  public:
    static SpatialReference from_wkt(const std::string& wkt);
    explicit operator bool() const { return handle_ != nullptr; }
    OGRSpatialReferenceH get() const { return handle_.get(); }

  private:
    struct Destroy {
        void operator()(void* handle) const;
    };
    explicit SpatialReference(void* handle) : handle_(handle) {}
    std::unique_ptr<void, Destroy> handle_;
};

}  // namespace terrains
