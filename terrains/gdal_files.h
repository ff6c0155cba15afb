#pragma once

#include <filesystem>

#include "terrains/references.h"

// Which files GDAL may open. GDAL asks these functions for every file, so that a raster made by a stranger
// reaches nothing that the user did not name: no other file, no server, no pipe.
namespace terrains {

// Takes GDAL's file system and its network from it. Called once, before GDAL opens anything. Then GDAL sees
// its own data folder, files in memory, and what a RasterFiles allows; it writes nothing but files in memory.
// False if this version of GDAL goes around it: then nothing may be opened.
bool close_file_system_to_gdal();

// While one lives, GDAL may read the raster `named` and the files beside it that are parts of it: those of
// its name with another ending (hill.prj, hill.tif.aux.xml, hill.hdr), or every .adf of an ESRI binary grid.
// A link is followed only to a file in the raster's own folder. With References::kAllowed: every local file.
class RasterFiles {
  public:
    RasterFiles(const std::filesystem::path& named, References references);
    ~RasterFiles();
    RasterFiles(const RasterFiles&) = delete;
    RasterFiles& operator=(const RasterFiles&) = delete;

    bool includes(const std::filesystem::path& file) const;

  private:
    bool is_own_folder(const std::filesystem::path& folder) const;

    std::filesystem::path raster_, folder_,
        folder_of_link_;     // canonical; folder_of_link_: where `named` stands
    std::string beginning_;  // of the names of its parts, "hill."
    bool is_binary_grid_ = false;
    References references_;
};

}  // namespace terrains
