#pragma once

#include <filesystem>
#include <optional>

namespace game {

// The TrueType file that panels are lettered with: COULOIR_FONT if set, there or not; else Roboto, then
// DejaVu Sans, where distributions put them. None: the reader's own built-in letters must do.
std::optional<std::filesystem::path> ui_font();

}  // namespace game
