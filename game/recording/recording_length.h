#pragma once

#include <filesystem>
#include <optional>

namespace game {

// Length of a recording, s, from the first and the last few kilobytes of its file: cheap for a list of many. Nothing is checked
// beyond that; nothing is returned if the numbers are not there.
std::optional<double> length_of_recording(const std::filesystem::path& path);

}  // namespace game
