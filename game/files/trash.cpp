#include "game/files/trash.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "files/descriptor.h"
#include "game/files/user_folders.h"

namespace game {
namespace {

namespace fs = std::filesystem;

// A path as the specification has it: percent signs before what an address does not allow.
std::string escaped(const fs::path& path) {
    constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.~/";
    std::string text;
    for (const char each : path.string())
        text += kPlain.find(each) != std::string_view::npos
                    ? std::string(1, each)
                    : fmt::format("%{:02X}", static_cast<unsigned char>(each));
    return text;
}

tl::unexpected<Failure> stays(const fs::path& file, int number) {
    return machine_fails(
        fmt::format("{}: cannot be moved to the trash: {}", file.string(), std::strerror(number)));
}

// Writes what the trash must know of a file before it comes, under a name that nothing there has. Returns that name.
Outcome<std::string> announce(const fs::path& trash, const fs::path& file) {
    const std::string text = fmt::format("[Trash Info]\nPath={}\nDeletionDate={:%Y-%m-%dT%H:%M:%S}\n",
                                         escaped(file), fmt::localtime(std::time(nullptr)));
    constexpr int kMostTries = 10'000;
    for (int i = 1; i < kMostTries; ++i) {
        const std::string name =
            i == 1 ? file.filename().string()
                   : fmt::format("{}-{}{}", file.stem().string(), i, file.extension().string());
        const fs::path info = trash / "info" / (name + ".trashinfo");
        const files::Descriptor made(open(info.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
        if (!made && errno == EEXIST) continue;
        if (!made) return stays(file, errno);
        if (write(made.number(), text.data(), text.size()) == static_cast<ssize_t>(text.size())) return name;
        const int number = errno;
        unlink(info.c_str());
        return stays(file, number);
    }
    return stays(file, EEXIST);
}

}  // namespace

Outcome<void> move_to_trash(const fs::path& file) {
    const auto couloir = data_folder("");
    if (!couloir) return tl::unexpected(couloir.error());
    const fs::path trash = couloir->parent_path().parent_path() / "Trash";
    std::error_code error;
    for (const char* part : {"info", "files"}) {
        fs::create_directories(trash / part, error);
        if (error) return stays(file, error.value());
        fs::permissions(trash, fs::perms::owner_all, error);
    }
    const fs::path whole = fs::absolute(file, error);
    const auto name = announce(trash, whole);
    if (!name) return tl::unexpected(name.error());
    const fs::path to = trash / "files" / *name;
    // Nothing may be there, though its announcement was not.
    if (renameat2(AT_FDCWD, whole.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return {};
    const int number = errno;
    unlink((trash / "info" / (*name + ".trashinfo")).c_str());
    return stays(file, number);
}

}  // namespace game
