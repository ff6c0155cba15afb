#pragma once

#include <filesystem>
#include <set>
#include <vector>

#include "terrains/references.h"

// Restricts which files GDAL may open. GDAL calls these functions for every file, so an untrusted raster
// reaches nothing that the user did not name: no other file, server or pipe.
namespace terrains {

// Replaces GDAL's file system and disables its network. Call once, before GDAL opens anything. GDAL then sees
// its own data folder, files in memory, and the files that a RasterFiles allows; it writes only files in
// memory. Returns false if this version of GDAL bypasses it: then nothing may be opened.
bool close_file_system_to_gdal();

// During its lifetime GDAL may read the raster `named` and its parts beside it: files of its name with
// another ending (hill.prj, hill.tif.aux.xml, hill.hdr), or every .adf of an ESRI binary grid. A link is
// followed only to a file in the raster's own folder. With References::kAllowed: every local file.
class RasterFiles {
  public:
    RasterFiles(const std::filesystem::path& named, References references);
    ~RasterFiles();
    RasterFiles(const RasterFiles&) = delete;
    RasterFiles& operator=(const RasterFiles&) = delete;

    bool includes(const std::filesystem::path& file) const;

    // Adds `file` to read(), if it is included. Locks nothing: only note_read() calls it.
    void note(const std::filesystem::path& file);
    // Every file that GDAL has opened for the raster so far, and every one noted; canonical.
    std::vector<std::filesystem::path> read() const;

  private:
    bool is_own_folder(const std::filesystem::path& folder) const;

    std::filesystem::path raster_, folder_,
        folder_of_link_;     // canonical; folder_of_link_: where `named` stands
    std::string beginning_;  // of the names of its parts, "hill."
    bool is_binary_grid_ = false;
    References references_;
    std::set<std::filesystem::path> read_;
};

// Adds `file` to what was read for every raster that includes it.
void note_read(const std::filesystem::path& file);

}  // namespace terrains
