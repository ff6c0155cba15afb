#include "game/files/shelf.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <system_error>
#include <tuple>

#include <fcntl.h>
#include <sys/stat.h>

#include <fmt/format.h>

#include "game/files/recordings_folder.h"
#include "game/files/text_file.h"
#include "game/files/trash.h"
#include "game/files/user_folders.h"

namespace game {
namespace {

namespace fs = std::filesystem;

constexpr const char *kRecordingEnding = ".couloir", *kPictureEnding = ".png",
                     *kCameraPathEnding = ".camera.toml";
constexpr std::size_t kMostInName = 200;  // bytes; a file system has 255
constexpr std::string_view kNever = "/\\<>:\"|?*";

// Bytes that some system does not allow in a name.
bool is_forbidden(char byte) {
    return kNever.find(byte) != std::string_view::npos || static_cast<unsigned char>(byte) < ' ';
}

// The name without blanks around it. Errors: it is none, or has what some system does not allow.
Outcome<std::string> usable_name(const std::string& name) {
    constexpr std::string_view kBlank = " \t";
    const std::size_t from = name.find_first_not_of(kBlank), to = name.find_last_not_of(kBlank);
    if (from == std::string::npos || name[from] == '.') return unusable("A file needs a name");
    std::string text = name.substr(from, to - from + 1);
    if (text.size() > kMostInName) return unusable(fmt::format("A name has at most {} bytes", kMostInName));
    for (const char each : text)
        if (is_forbidden(each)) return unusable(fmt::format("A name cannot have {}", kNever));
    return text;
}

bool move_to(const fs::path& from, const fs::path& to) {
    return renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0;
}

}  // namespace

Outcome<fs::path> shelf_folder(ShelfKind kind) {
    switch (kind) {
        case ShelfKind::kRecording:
            return recordings_folder();
        case ShelfKind::kScreenshot:
            return screenshots_folder();
        case ShelfKind::kWorld:
            return data_folder("scenes");
        case ShelfKind::kChallenge:
            break;
    }
    return data_folder("challenges");
}

std::string shelf_name(const std::string& title) {
    std::size_t end = std::min(title.size(), kMostInName);
    while (end < title.size() && end > 0 && (static_cast<unsigned char>(title[end]) & 0xc0) == 0x80) --end;
    std::string name = title.substr(0, end);
    std::ranges::replace_if(name, is_forbidden, '-');
    return usable_name(name).value_or("mine");
}

Outcome<fs::path> keep_on_shelf(ShelfKind kind, const std::string& name, const std::string& text) {
    const auto usable = usable_name(name);
    if (!usable) return tl::unexpected(usable.error());
    const auto folder = shelf_folder(kind);
    if (!folder) return tl::unexpected(folder.error());
    auto path = new_file(*folder, *usable, "couloir");
    if (!path) return path;
    if (const auto written = write_text(*path, text); !written) {
        std::error_code ignored;  // then it stays empty, and nobody can open it
        fs::remove(*path, ignored);
        return tl::unexpected(written.error());
    }
    return path;
}

fs::path picture_of(const fs::path& recording) {
    return fs::path(recording).replace_extension(kPictureEnding);
}

fs::path camera_path_of(const fs::path& recording) {
    return fs::path(recording).replace_extension(kCameraPathEnding);
}

std::vector<ShelfFile> shelf(ShelfKind kind, std::size_t most) {
    std::vector<ShelfFile> files;
    const auto folder = shelf_folder(kind);
    if (!folder) return files;
    const char* const ending = kind == ShelfKind::kScreenshot ? kPictureEnding : kRecordingEnding;
    std::error_code error;
    for (fs::directory_iterator entry(*folder, error), end; !error && entry != end; entry.increment(error)) {
        struct stat facts {};
        if (entry->path().extension() != ending || stat(entry->path().c_str(), &facts) != 0) continue;
        // An empty one is still being made.
        if (S_ISREG(facts.st_mode) && facts.st_size > 0) files.push_back({entry->path(), facts.st_mtime});
    }
    std::ranges::sort(files, [](const ShelfFile& one, const ShelfFile& other) {
        return std::tie(other.written, other.file) < std::tie(one.written, one.file);
    });
    if (files.size() > most) files.resize(most);
    return files;
}

Outcome<fs::path> rename_on_shelf(const fs::path& file, const std::string& name) {
    const auto usable = usable_name(name);
    if (!usable) return tl::unexpected(usable.error());
    const fs::path to = file.parent_path() / (*usable + file.extension().string());
    if (to == file) return to;
    if (!move_to(file, to))
        return errno == EEXIST ? unusable(fmt::format("There is a {} already", to.filename().string()))
                               : machine_fails(fmt::format("{}: cannot be renamed: {}", file.string(),
                                                           std::strerror(errno)));
    // Without a picture, or beside one that has that name already, it is one without.
    if (file.extension() != kRecordingEnding) return to;
    move_to(picture_of(file), picture_of(to));
    move_to(camera_path_of(file), camera_path_of(to));
    return to;
}

Outcome<void> throw_away(const fs::path& file) {
    if (auto moved = move_to_trash(file); !moved) return moved;
    if (file.extension() != kRecordingEnding) return {};
    std::error_code error;
    fs::remove(picture_of(file), error);
    const fs::path camera_path = camera_path_of(file);
    return fs::exists(camera_path, error) ? move_to_trash(camera_path) : Outcome<void>();
}

}  // namespace game
