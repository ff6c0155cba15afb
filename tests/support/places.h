#pragma once

#include <filesystem>
#include <optional>

// Where tests find things and may write.
namespace support {

// The checkout that the tests were built from.
std::filesystem::path source_dir();

// The folder that this build writes into.
std::filesystem::path build_dir();

// The program of the same build.
std::filesystem::path program();

// The folder of real terrain named by COULOIR_DEM_DIR; none where that is unset or empty, and then a test
// that needs it is skipped: if (!dem_dir()) GTEST_SKIP() << "COULOIR_DEM_DIR is not set";
std::optional<std::filesystem::path> dem_dir();

// A new empty folder that goes with the object, for the files that a test writes.
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
