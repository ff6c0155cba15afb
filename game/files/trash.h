#pragma once

#include <filesystem>

#include "game/base/outcome.h"

namespace game {

// Moves a file into the trash of the desktop, from where a person can take it back: Trash in the XDG data folder, after the
// freedesktop.org Trash specification 1.0. Written out here, because the library that does it is that of one desktop. Errors
// (status 3): it is on another file system, or cannot be moved; it then stays where it is.
Outcome<void> move_to_trash(const std::filesystem::path& file);

}  // namespace game
