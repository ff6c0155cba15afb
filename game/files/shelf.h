#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "game/base/outcome.h"

namespace game {

// What a person has made in the window, as files that can be looked at, renamed and thrown away. Worlds are in couloir/scenes of
// the XDG data folder, and challenges in couloir/challenges; both are recordings.
enum class ShelfKind : std::uint8_t { kRecording, kScreenshot, kWorld, kChallenge };
inline constexpr std::array kShelfKinds{ShelfKind::kRecording, ShelfKind::kScreenshot, ShelfKind::kWorld,
                                        ShelfKind::kChallenge};

// Their folder. Errors: neither XDG_DATA_HOME nor HOME is set.
Outcome<std::filesystem::path> shelf_folder(ShelfKind kind);

struct ShelfFile {
    std::filesystem::path file;
    std::int64_t written = 0;  // s since 1970, last
};
// The newest of a kind, the newest first, at most so many; none if there is no such folder.
std::vector<ShelfFile> shelf(ShelfKind kind, std::size_t most);

// A title as a name that a file can have.
std::string shelf_name(const std::string& title);

// Writes the text of a recording into a new file of that name, whole or not at all; NAME-2 and so on if the name is taken.
// Returns its path. Errors: the name is none (2); it cannot be written, and then nothing is left of it (3).
Outcome<std::filesystem::path> keep_on_shelf(ShelfKind kind, const std::string& name,
                                             const std::string& text);

// The picture of a recording lies beside it.
std::filesystem::path picture_of(const std::filesystem::path& recording);

// The camera path that a person has made for a recording, if it was saved, lies beside it too.
std::filesystem::path camera_path_of(const std::filesystem::path& recording);

// Gives a file another name in its folder, and its picture and camera path with it; the ending stays. Returns its path. Errors: the name is
// none, or another file has it (2); the file cannot be renamed (3).
Outcome<std::filesystem::path> rename_on_shelf(const std::filesystem::path& file, const std::string& name);

// Moves a file into the trash. Its picture is deleted, and its camera path is in the trash too. Errors: as move_to_trash().
Outcome<void> throw_away(const std::filesystem::path& file);

}  // namespace game
