#include "game/app/sharing.h"

#include <exception>
#include <system_error>
#include <utility>

#include "game/base/process.h"
#include "game/files/text_file.h"
#include "game/files/user_folders.h"

namespace game {

namespace fs = std::filesystem;

Outcome<void> Sharing::begin(std::string recording, std::string name, PageOptions options) {
    progress_ = 0;
    return job_.begin([this, recording = std::move(recording), name = std::move(name),
                       options = std::move(options)](const std::atomic<bool>& stopped) {
        return share(recording, name, options, stopped);
    });
}

std::optional<double> Sharing::progress() const {
    if (!job_.is_busy()) return std::nullopt;
    return static_cast<double>(progress_);
}

// Nothing remains of an unfinished slide.
Outcome<Sharing::Shared> Sharing::share(const std::string& recording, const std::string& name,
                                        const PageOptions& options, const std::atomic<bool>& stopped) {
    const auto parent = data_folder("shared");
    if (!parent) return tl::unexpected(parent.error());
    const auto folder = new_folder(*parent, name);
    if (!folder) return tl::unexpected(folder.error());
    Outcome<PageReport> page;
    try {
        page = write_into(*folder, recording, options, stopped);
    } catch (const std::exception& thrown) {  // such as out of memory
        page = tl::unexpected(failure_of(thrown));
    }
    if (page && !stopped) return Shared{*folder, *page};
    std::error_code error;
    for (const fs::path& left : {*folder / kPage, *folder / kRecording, *folder}) fs::remove(left, error);
    return tl::unexpected(page ? Failure{Failure::kMachine, "it was stopped"} : page.error());
}

Outcome<PageReport> Sharing::write_into(const fs::path& folder, const std::string& recording,
                                        const PageOptions& options, const std::atomic<bool>& stopped) {
    if (auto written = write_text(folder / kRecording, recording); !written)
        return tl::unexpected(written.error());
    return write_page_(folder / kRecording, folder / kPage, options, &stopped, &progress_);
}

}  // namespace game
