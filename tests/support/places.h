#pragma once

#include <filesystem>
#include <optional>

// Where tests find and write files.
namespace support {

// The source checkout that the tests were built from.
std::filesystem::path source_dir();

// The build folder.
std::filesystem::path build_dir();

// The program of the same build.
std::filesystem::path program();

// The folder of real terrain named by COULOIR_DEM_DIR; none if that is unset or empty. A test that needs it
// is then skipped: if (!dem_dir()) GTEST_SKIP() << "COULOIR_DEM_DIR is not set";
std::optional<std::filesystem::path> dem_dir();

// A new empty folder for the files of a test, deleted with the object.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace support
