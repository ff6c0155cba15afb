#pragma once

#include <filesystem>
#include <string>

#include "game/base/outcome.h"

namespace game {

// The default folder for recordings: couloir/recordings in the XDG data folder (XDG_DATA_HOME, else
// ~/.local/share). Errors: neither XDG_DATA_HOME nor HOME is set.
Outcome<std::filesystem::path> recordings_folder();

// Creates a new, empty file there, named by local time and scene: 2026-11-21_18-04-59_alpine-valley.couloir.
// Errors: it cannot be created.
Outcome<std::filesystem::path> next_recording(const std::string& scene);

}  // namespace game
