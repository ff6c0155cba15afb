#pragma once

#include <filesystem>
#include <string>

namespace game {

// XXH3 of a file's bytes as 16 hexadecimal digits; of the readable ones if reading fails.
std::string file_hash(const std::filesystem::path& path);

}  // namespace game
