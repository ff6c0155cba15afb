#include "game/files/ui_font.h"

#include <cstdlib>
#include <system_error>

namespace game {

// Roboto's digits are all equally wide, so that a reading does not tremble as it changes, and its lines are a
// seventh shorter than DejaVu's.
std::optional<std::filesystem::path> ui_font() {
    if (const char* named = std::getenv("COULOIR_FONT"); named != nullptr && *named != '\0') return named;
    constexpr const char* kPlaces[] = {
        "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",  // Debian, Ubuntu
        "/usr/share/fonts/TTF/Roboto-Regular.ttf",                                 // Arch
        "/usr/share/fonts/google-roboto/Roboto-Regular.ttf",                       // Fedora
        "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",                         // Debian, Ubuntu, openSUSE
        "/usr/share/fonts/TTF/DejaVuSans.ttf",                                     // Arch
        "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",                       // Fedora
    };
    std::error_code error;
    for (const char* place : kPlaces)
        if (std::filesystem::is_regular_file(place, error)) return place;
    return std::nullopt;
}

}  // namespace game
