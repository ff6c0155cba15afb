#include "tests/support/places.h"

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>

namespace support {

namespace fs = std::filesystem;

fs::path source_dir() {
    return COULOIR_SOURCE_DIR;
}

fs::path build_dir() {
    return COULOIR_BINARY_DIR;
}

fs::path program() {
    return build_dir() / "bin" / "couloir";
}

std::optional<fs::path> dem_dir() {
    const char* folder = std::getenv("COULOIR_DEM_DIR");
    if (folder == nullptr || *folder == '\0') return std::nullopt;
    return fs::path(folder);
}

TemporaryFolder::TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "couloir-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder " + name);
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code left_behind;  // leftovers in the temporary folder must not fail a test
    fs::remove_all(path_, left_behind);
}

}  // namespace support
