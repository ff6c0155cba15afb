#pragma once

#include <filesystem>
#include <vector>

namespace terrains::test {

// Moves GDAL's files from a folder in memory, "/vsimem/made", to `folder`: GDAL may write nowhere else.
std::vector<std::filesystem::path> unload(const char* memory, const std::filesystem::path& folder);

}  // namespace terrains::test
