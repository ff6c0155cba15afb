#include "game/files/text_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iterator>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "files/destination.h"
#include "files/input.h"
#include "files/whole_file.h"

namespace game {

namespace fs = std::filesystem;

Outcome<std::string> read_text(const fs::path& path) {
    auto file = files::open_input(path);
    if (!file) return machine_fails(file.error());
    std::string text{std::istreambuf_iterator<char>(*file), {}};
    if (file->bad()) return machine_fails(fmt::format("{}: cannot be read", path.string()));
    return text;
}

Outcome<void> write_text(const fs::path& path, std::string_view text) {
    if (auto placed = make_place_for(path); !placed) return placed;
    if (auto written = files::write(path, text); !written) return machine_fails(written.error());
    return {};
}

std::optional<std::filesystem::path> set_aside(const std::filesystem::path& path) {
    auto aside = std::filesystem::path(path).concat(".damaged");
    std::error_code error;
    std::filesystem::rename(path, aside, error);
    return error ? std::nullopt : std::optional(std::move(aside));
}

Outcome<void> make_place_for(const fs::path& path) {
    const files::Destination to = files::destination_of(path);
    if (to.kind == files::Destination::Kind::kFolder)
        return machine_fails(fmt::format("{}: is a folder, not a file", path.string()));
    // A device exists already, in a folder that few users may write into.
    if (to.kind != files::Destination::Kind::kFile || !to.path.has_parent_path()) return {};
    return make_folder(to.path.parent_path());
}

Outcome<void> make_folder(const fs::path& path) {
    std::error_code error;
    fs::create_directories(path, error);
    if (error) return machine_fails(fmt::format("{}: cannot be created: {}", path.string(), error.message()));
    if (!fs::is_directory(path)) return machine_fails(fmt::format("{}: is not a folder", path.string()));
    if (access(path.c_str(), W_OK | X_OK) != 0)
        return machine_fails(
            fmt::format("{}: cannot be written into: {}", path.string(), std::strerror(errno)));
    return {};
}

}  // namespace game
