#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "game/base/outcome.h"

namespace game {

// What a person has saved: worlds in couloir/scenes of the XDG data folder, and challenges in couloir/challenges. Both are
// recordings, each named TITLE-DATE-TIME.couloir.
enum class OwnKind { kWorld, kChallenge };

// Their folder. Errors: neither XDG_DATA_HOME nor HOME is set.
Outcome<std::filesystem::path> own_folder(OwnKind kind);

// Writes the text of a recording into a new file of that folder, whole or not at all. Returns its path. Errors: it cannot
// be written, and then nothing is left of it (status 3).
Outcome<std::filesystem::path> keep_own(OwnKind kind, const std::string& title, const std::string& text);

struct OwnFile {
    OwnKind kind;
    std::filesystem::path path;
};
// The newest of both kinds, the newest first, at most so many.
std::vector<OwnFile> own_files(std::size_t most);

}  // namespace game
