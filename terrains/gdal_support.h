#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gdal.h>
#include <tl/expected.hpp>

#include "terrains/gdal_files.h"

// GDAL support for the readers and writers here. Include it from sources only, never from a format's header:
// GDAL's names stay in this folder's .cpp files.
namespace terrains {

// Captures GDAL's and PROJ's messages on this thread during its lifetime, so that nothing is printed. Nests.
// Registers GDAL's drivers on first use.
class GdalErrors {
  public:
    GdalErrors();
    ~GdalErrors();
    GdalErrors(const GdalErrors&) = delete;
    GdalErrors& operator=(const GdalErrors&) = delete;

    bool any() const { return !first_.empty(); }
    // GDAL's first failure message, on one line; "no reason given" if there was none.
    std::string first() const;
    void forget() { first_.clear(); }

  private:
    // GDAL holds its address and writes to it throughout this object's lifetime, even if the object is const.
    mutable std::string first_;
};

struct CloseDataset {
    void operator()(void* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, CloseDataset>;

// Registers GDAL's VRT driver during its lifetime, if references are allowed.
class VirtualRasters {
  public:
    explicit VirtualRasters(References references);
    ~VirtualRasters();
    VirtualRasters(const VirtualRasters&) = delete;
    VirtualRasters& operator=(const VirtualRasters&) = delete;

  private:
    bool registered_ = false;
};

// A raster open for reading, and the files that GDAL may read for it.
class Raster {
  public:
    // Opens one of the formats in kFormats (gdal_support.cpp), and VRT if references are allowed; never reads
    // the network. Errors: missing, no file, not a raster, damaged, a raster that refers to other files or
    // servers. An error is one sentence that names the file.
    static tl::expected<Raster, std::string> open(const std::filesystem::path& path, References references);

    GDALDatasetH get() const { return dataset_.get(); }
    const std::filesystem::path& path() const { return path_; }  // absolute

    // Every file that was read for the raster so far, and every one that it names, such as the sources of a
    // virtual raster; canonical.
    std::vector<std::filesystem::path> files() const { return files_->read(); }

  private:
    Raster() = default;

    std::filesystem::path path_;
    std::unique_ptr<RasterFiles> files_;  // outlive the dataset
    std::unique_ptr<VirtualRasters> virtual_rasters_;
    Dataset dataset_;
};

struct DestroyReference {
    void operator()(void* handle) const;
};
using OwnedReference = std::unique_ptr<void, DestroyReference>;  // of an OGRSpatialReference

// A coordinate system with x east-like and y north-like. Empty if the WKT cannot be read, if it names a file to be
// read (a correction grid with a path), or if it has the code of another kind of system than it describes.
class SpatialReference {
  public:
    static SpatialReference from_wkt(const std::string& wkt);
    explicit operator bool() const { return handle_ != nullptr; }
    OGRSpatialReferenceH get() const { return handle_.get(); }

  private:
    explicit SpatialReference(void* handle) : handle_(handle) {}
    bool has_code_of_another_kind() const;

    OwnedReference handle_;
};

}  // namespace terrains
