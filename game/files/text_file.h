#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "game/base/outcome.h"

namespace game {

// Reads a whole file. Errors: it cannot be read, or is no file with an end (status 3).
Outcome<std::string> read_text(const std::filesystem::path& path);

// Writes a whole file (files/whole_file.h); makes its folder. Errors: status 3.
Outcome<void> write_text(const std::filesystem::path& path, std::string_view text);

// Renames a damaged file to NAME.damaged, so that nobody reads it and nothing is lost. Its new name; nothing if that cannot be.
std::optional<std::filesystem::path> set_aside(const std::filesystem::path& path);

// Checks that write_text() could write this file, and makes its folder. Call it before long work that ends in
// this file. Errors: status 3.
Outcome<void> make_place_for(const std::filesystem::path& path);

// Makes a writable folder. Errors: status 3.
Outcome<void> make_folder(const std::filesystem::path& path);

}  // namespace game
