#include "game/text_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "files/whole_file.h"

namespace game {

namespace fs = std::filesystem;

Outcome<void> write_text(const fs::path& path, std::string_view text) {
    if (auto placed = make_place_for(path); !placed) return placed;
    if (auto written = files::write(path, text); !written) return machine_fails(written.error());
    return {};
}

Outcome<void> make_place_for(const fs::path& path) {
    std::error_code error;
    if (fs::is_directory(path, error))
        return machine_fails(fmt::format("{}: is a folder, not a file", path.string()));
    return path.has_parent_path() ? make_folder(path.parent_path()) : Outcome<void>();
}

Outcome<void> make_folder(const fs::path& path) {
    std::error_code error;
    fs::create_directories(path, error);
    if (error) return machine_fails(fmt::format("{}: cannot be made: {}", path.string(), error.message()));
    if (!fs::is_directory(path)) return machine_fails(fmt::format("{}: is not a folder", path.string()));
    if (access(path.c_str(), W_OK | X_OK) != 0)
        return machine_fails(
            fmt::format("{}: cannot be written into: {}", path.string(), std::strerror(errno)));
    return {};
}

}  // namespace game
