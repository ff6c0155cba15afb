#include "game/files/user_folders.h"

#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>

#include <fcntl.h>
#include <sys/stat.h>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "files/descriptor.h"
#include "game/files/text_file.h"

namespace game {
namespace {

namespace fs = std::filesystem;

fs::path folder_in(const char* variable) {
    const char* value = std::getenv(variable);
    return value ? value : "";
}

// The value of a line of user-dirs.dirs: "$HOME/Pictures" or "/srv/pictures", with quotes, and a backslash
// before special characters. Nothing if it is neither, or the home folder, which means that there is none.
std::optional<fs::path> user_folder(std::string_view quoted, const fs::path& home) {
    if (quoted.size() < 2 || quoted.front() != '"') return std::nullopt;
    std::string value;
    for (std::size_t i = 1; i < quoted.size() && quoted[i] != '"'; ++i) {
        if (quoted[i] == '\\' && i + 1 < quoted.size()) ++i;
        value += quoted[i];
    }
    constexpr std::string_view kHome = "$HOME/";
    if (value.starts_with(kHome)) value = (home / value.substr(kHome.size())).string();
    const fs::path folder = fs::path(value).lexically_normal();
    const bool is_home = (folder / "").lexically_normal() == (home / "").lexically_normal();
    return folder.is_absolute() && !is_home ? std::optional(folder) : std::nullopt;
}

std::optional<fs::path> pictures_folder() {
    const fs::path home = folder_in("HOME");
    fs::path settings = folder_in("XDG_CONFIG_HOME");
    if (!settings.is_absolute()) settings = home / ".config";
    if (!home.is_absolute()) return std::nullopt;
    constexpr std::string_view kKey = "XDG_PICTURES_DIR=";
    std::optional<fs::path> found;
    std::ifstream lines(settings / "user-dirs.dirs");
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(kKey)) found = user_folder(std::string_view(line).substr(kKey.size()), home);
    std::error_code error;
    return found && fs::is_directory(*found, error) ? found : std::nullopt;
}

// couloir/NAME in the folder that a variable names, else in this one below the home folder.
Outcome<fs::path> folder_of_user(const char* variable, const char* usual, const std::string& name) {
    // The XDG Base Directory Specification says to ignore a relative path.
    if (const fs::path folder = folder_in(variable); folder.is_absolute()) return folder / "couloir" / name;
    if (const fs::path home = folder_in("HOME"); home.is_absolute()) return home / usual / "couloir" / name;
    return machine_fails(
        fmt::format("no folder for {}: neither {} nor HOME is set; set one", name, variable));
}

// Tries NAME, NAME-2, ... until `create` succeeds. It returns false, with a reason in errno, if it does not.
template <class Create>
Outcome<fs::path> create_new(const fs::path& folder, const std::string& name, const std::string& ending,
                             const Create& create) {
    if (auto made = make_folder(folder); !made) return tl::unexpected(made.error());
    fs::path path = folder / (name + ending);
    for (int n = 2; !create(path); ++n) {
        if (errno != EEXIST)
            return machine_fails(
                fmt::format("{}: cannot be created: {}", path.string(), std::strerror(errno)));
        path = folder / fmt::format("{}-{}{}", name, n, ending);
    }
    return path;
}

}  // namespace

Outcome<fs::path> data_folder(const std::string& name) {
    return folder_of_user("XDG_DATA_HOME", ".local/share", name);
}

Outcome<fs::path> config_folder(const std::string& name) {
    return folder_of_user("XDG_CONFIG_HOME", ".config", name);
}

Outcome<fs::path> screenshots_folder() {
    if (const auto pictures = pictures_folder()) return *pictures / "Couloir";
    return data_folder("screenshots");
}

std::string file_name_of(const std::string& scene) {
    std::string name;
    for (const char c : scene) name += std::isalnum(static_cast<unsigned char>(c)) || c == '-' ? c : '-';
    return name.empty() ? "scene" : name;
}

std::string dated_name(const std::string& scene) {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    return fmt::format("{}-{:%Y-%m-%d-%H-%M-%S}", file_name_of(scene), fmt::localtime(now));
}

Outcome<fs::path> new_file(const fs::path& folder, const std::string& name, const std::string& extension) {
    return create_new(folder, name, "." + extension, [](const fs::path& path) {
        return static_cast<bool>(
            files::Descriptor(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)));
    });
}

Outcome<fs::path> new_folder(const fs::path& folder, const std::string& name) {
    return create_new(folder, name, "", [](const fs::path& path) { return mkdir(path.c_str(), 0777) == 0; });
}

}  // namespace game
