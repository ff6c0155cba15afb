#pragma once

#include <filesystem>

namespace files {

// Makes this open file the writer of what it refers to, until it is closed, however its process ends. False:
// another one is. A file system that knows no locks gives everybody the lock.
bool lock(int descriptor);

// Somebody is the writer of that file.
bool is_locked(const std::filesystem::path& path);

}  // namespace files
