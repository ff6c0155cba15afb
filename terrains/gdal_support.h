#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <gdal.h>
#include <tl/expected.hpp>

#include "terrains/gdal_files.h"

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

// Makes VRT known to GDAL while one lives that allows references, and unknown again.
class VirtualRasters {
  public:
    explicit VirtualRasters(References references);
    ~VirtualRasters();
    VirtualRasters(const VirtualRasters&) = delete;
    VirtualRasters& operator=(const VirtualRasters&) = delete;

  private:
    bool registered_ = false;
};

// A raster that is open for reading, and the files that GDAL may read for it.
class Raster {
  public:
    // Opens one of the formats in kFormats (gdal_support.cpp), and VRT where references are allowed; never
    // anything from the network. Errors: missing, no file, not a raster, damaged, a raster that refers to
    // other files or servers; one sentence that names the file.
    static tl::expected<Raster, std::string> open(const std::filesystem::path& path, References references);

    GDALDatasetH get() const { return dataset_.get(); }

  private:
    Raster() = default;

    std::unique_ptr<RasterFiles> files_;  // outlive the dataset
    std::unique_ptr<VirtualRasters> virtual_rasters_;
    Dataset dataset_;
};

// A coordinate system with x east-like and y north-like. Empty where the WKT could not be read, and where it
// names a file of its own to be read (a grid of corrections with a path).
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
