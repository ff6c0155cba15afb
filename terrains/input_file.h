#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <tl/expected.hpp>

namespace terrains {

// Whether a file may lead to other files: a virtual raster names its sources, a scene its terrain. Nothing
// here ever asks the network.
enum class References { kRefused, kAllowed };

// Whether `path` is a file with an end. Every reader asks before it opens a file, because a pipe or a device
// could be read for ever. Follows links. Errors, in one sentence that names the file: missing, a folder, a
// pipe, a device, a socket.
tl::expected<void, std::string> check_input(const std::filesystem::path& path);

// Opens a file for reading, in bytes. Errors: those of check_input(), and a file that may not be read.
tl::expected<std::ifstream, std::string> open_input(const std::filesystem::path& path);

}  // namespace terrains
