#include "game/files/recordings_folder.h"

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "game/files/user_folders.h"

namespace game {

namespace fs = std::filesystem;

Outcome<fs::path> recordings_folder() {
    auto folder = data_folder("recordings");
    if (!folder) folder.error().sentence += ", or give --record FILE";
    return folder;
}

Outcome<fs::path> next_recording(const std::string& scene) {
    const auto folder = recordings_folder();
    if (!folder) return tl::unexpected(folder.error());
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    const std::string name = fmt::format("{:%Y-%m-%d_%H-%M-%S}_{}", fmt::localtime(now), file_name_of(scene));
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
