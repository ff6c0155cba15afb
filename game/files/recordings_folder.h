#pragma once

#include <filesystem>
#include <string>

#include "game/base/outcome.h"

namespace game {

// Where sessions are recorded unless somebody says otherwise: couloir/recordings in the XDG data folder
// (XDG_DATA_HOME, else ~/.local/share). Errors: neither XDG_DATA_HOME nor HOME is set.
Outcome<std::filesystem::path> recordings_folder();

// A new, empty file there, named by local time and scene:
// 2026-11-21_18-04-59_alpine-valley.couloir. Errors: it cannot be made.
Outcome<std::filesystem::path> next_recording(const std::string& scene);

}  // namespace game
