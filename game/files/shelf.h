#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "game/base/outcome.h"

namespace game {

// What a person has made in the window, as files that can be looked at, renamed and thrown away.
enum class ShelfKind : std::uint8_t { kRecording, kScreenshot };

struct ShelfFile {
    std::filesystem::path file;
    std::int64_t written = 0;  // s since 1970, last
};
// The newest of a kind, the newest first, at most so many; none if there is no such folder.
std::vector<ShelfFile> shelf(ShelfKind kind, std::size_t most);

// The picture of a recording lies beside it.
std::filesystem::path picture_of(const std::filesystem::path& recording);

// Gives a file another name in its folder, and its picture with it; the ending stays. Returns its path. Errors: the name is
// none, or another file has it (2); the file cannot be renamed (3).
Outcome<std::filesystem::path> rename_on_shelf(const std::filesystem::path& file, const std::string& name);

// Moves a file and its picture into the trash. Errors: as move_to_trash().
Outcome<void> throw_away(const std::filesystem::path& file);

}  // namespace game
