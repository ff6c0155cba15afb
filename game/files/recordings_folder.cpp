#include "game/files/recordings_folder.h"

#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fmt/chrono.h>
#include <fmt/format.h>

namespace game {
namespace {

namespace fs = std::filesystem;

// Replaces characters that some system does not allow in a file name.
std::string plain(const std::string& scene) {
    std::string name;
    for (const char c : scene) name += std::isalnum(static_cast<unsigned char>(c)) || c == '-' ? c : '-';
    return name.empty() ? "scene" : name;
}

}  // namespace

Outcome<fs::path> recordings_folder() {
    const auto folder_of = [](const char* variable) {
        const char* value = std::getenv(variable);
        return fs::path(value ? value : "");
    };
    // The XDG Base Directory Specification says to ignore a relative XDG_DATA_HOME.
    if (const fs::path data = folder_of("XDG_DATA_HOME"); data.is_absolute())
        return data / "couloir/recordings";
    if (const fs::path home = folder_of("HOME"); home.is_absolute())
        return home / ".local/share/couloir/recordings";
    return machine_fails(
        "no folder for recordings: neither XDG_DATA_HOME nor HOME is set; set one, or give --record FILE");
}

Outcome<fs::path> next_recording(const std::string& scene) {
    const auto folder = recordings_folder();
    if (!folder) return tl::unexpected(folder.error());
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    const std::string name = fmt::format("{:%Y-%m-%d_%H-%M-%S}_{}", fmt::localtime(now), plain(scene));
    std::error_code error;
    fs::create_directories(*folder, error);
    fs::path path = *folder / (name + ".couloir");
    // Created here, so that a second sandbox that starts in the same second takes another name.
    std::FILE* file = nullptr;
    for (int n = 2; !(file = std::fopen(path.c_str(), "wbx")) && errno == EEXIST; ++n)
        path = *folder / fmt::format("{}_{}.couloir", name, n);
    if (!file)
        return machine_fails(fmt::format("{}: cannot be written: {}", path.string(), std::strerror(errno)));
    std::fclose(file);
    return path;
}

}  // namespace game
