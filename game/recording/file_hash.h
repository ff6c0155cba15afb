#pragma once

#include <filesystem>
#include <string>

namespace game {

// XXH3 of a file's bytes as 16 digits; of as many as can be read.
std::string file_hash(const std::filesystem::path& path);

}  // namespace game
