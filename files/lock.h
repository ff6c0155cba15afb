#pragma once

#include <filesystem>

namespace files {

// Makes this open file the only writer of its file, until it is closed, however its process ends. Returns
// false if another writer exists. On a file system without locks it always succeeds.
bool lock(int descriptor);

// Whether that file has a writer.
bool is_locked(const std::filesystem::path& path);

}  // namespace files
