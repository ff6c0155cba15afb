#pragma once

#include <filesystem>
#include <string_view>

#include "game/base/outcome.h"

namespace game {

// Writes a whole file (files/whole_file.h); makes its folder. Errors: status 3.
Outcome<void> write_text(const std::filesystem::path& path, std::string_view text);

// Whether write_text() would find a place for this file; makes its folder. To be asked before long work whose
// result goes there. Errors: status 3.
Outcome<void> make_place_for(const std::filesystem::path& path);

// Makes a folder that can be written into. Errors: status 3.
Outcome<void> make_folder(const std::filesystem::path& path);

}  // namespace game
