#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <tl/expected.hpp>

namespace files {

// Whether `path` is a file with an end. Every reader checks before it opens a file, because reading a pipe or
// a device might never end. Follows links. Errors, in one sentence that names the file: missing, a folder, a
// pipe, a device, a socket.
tl::expected<void, std::string> check_input(const std::filesystem::path& path);

// Opens a file for reading, in bytes. Errors: those of check_input(), and no permission to read.
tl::expected<std::ifstream, std::string> open_input(const std::filesystem::path& path);

// Whether `path` is in the folder or below it, after following links; "" is the working folder. False if either
// cannot be resolved.
bool is_within(const std::filesystem::path& folder, const std::filesystem::path& path);

}  // namespace files
