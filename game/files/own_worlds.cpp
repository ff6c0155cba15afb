#include "game/files/own_worlds.h"

#include <algorithm>
#include <system_error>
#include <tuple>

#include "game/files/text_file.h"
#include "game/files/user_folders.h"

namespace game {

namespace fs = std::filesystem;

Outcome<fs::path> own_folder(OwnKind kind) {
    return data_folder(kind == OwnKind::kWorld ? "scenes" : "challenges");
}

Outcome<fs::path> keep_own(OwnKind kind, const std::string& title, const std::string& text) {
    const auto folder = own_folder(kind);
    if (!folder) return tl::unexpected(folder.error());
    auto path = new_file(*folder, dated_name(title), "couloir");
    if (!path) return path;
    if (const auto written = write_text(*path, text); !written) {
        std::error_code ignored;  // then it stays empty, and nobody can open it
        fs::remove(*path, ignored);
        return tl::unexpected(written.error());
    }
    return path;
}

std::vector<OwnFile> own_files(std::size_t most) {
    struct Dated {
        fs::file_time_type written;
        OwnFile file;
    };
    std::vector<Dated> all;
    for (const OwnKind kind : {OwnKind::kWorld, OwnKind::kChallenge}) {
        const auto folder = own_folder(kind);
        if (!folder) continue;
        std::error_code error;
        for (fs::directory_iterator entry(*folder, error), end; !error && entry != end;
             entry.increment(error)) {
            std::error_code gone;
            const auto written = fs::last_write_time(entry->path(), gone);
            // An empty one is still being made.
            const bool is_whole = !gone && fs::file_size(entry->path(), gone) > 0 && !gone;
            if (is_whole && entry->path().extension() == ".couloir")
                all.push_back({written, {kind, entry->path()}});
        }
    }
    std::ranges::sort(all, [](const Dated& one, const Dated& other) {
        return std::tie(other.written, other.file.path) < std::tie(one.written, one.file.path);
    });
    if (all.size() > most) all.resize(most);
    std::vector<OwnFile> files;
    files.reserve(all.size());
    for (Dated& each : all) files.push_back(std::move(each.file));
    return files;
}

}  // namespace game
