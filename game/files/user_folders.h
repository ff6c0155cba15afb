#pragma once

#include <filesystem>
#include <string>

#include "game/base/outcome.h"

namespace game {

// couloir/NAME in the XDG data folder (XDG_DATA_HOME, else ~/.local/share). Errors: neither XDG_DATA_HOME nor
// HOME is set.
Outcome<std::filesystem::path> data_folder(const std::string& name);

// The same in the XDG configuration folder (XDG_CONFIG_HOME, else ~/.config).
Outcome<std::filesystem::path> config_folder(const std::string& name);

// Where screenshots go: Couloir in the user's pictures folder, which user-dirs.dirs of the XDG configuration
// folder names, or else couloir/screenshots in the XDG data folder. Errors: as for data_folder().
Outcome<std::filesystem::path> screenshots_folder();

// A scene's name without the characters that some system does not allow in a file name.
std::string file_name_of(const std::string& scene);

// SCENE-DATE-TIME by local time: winter-valley-2026-11-21-18-04-59.
std::string dated_name(const std::string& scene);

// Creates a new, empty file in a folder, which it makes: NAME.EXTENSION, or else NAME-2.EXTENSION and so on.
// Errors: it cannot be created.
Outcome<std::filesystem::path> new_file(const std::filesystem::path& folder, const std::string& name,
                                        const std::string& extension);

// The same for a folder.
Outcome<std::filesystem::path> new_folder(const std::filesystem::path& folder, const std::string& name);

}  // namespace game
