#include "game/app/sharing.h"

#include <chrono>
#include <system_error>
#include <utility>

#include "game/base/process.h"
#include "game/files/text_file.h"
#include "game/files/user_folders.h"
#include "sim/core/check.h"

namespace game {

namespace fs = std::filesystem;

Sharing::~Sharing() {
    stop_ = true;
    if (job_.valid()) job_.wait();
}

Outcome<void> Sharing::begin(std::string recording, std::string name, PageOptions options) {
    CHECK(!job_.valid());
    progress_ = 0;
    try {
        job_ = std::async(std::launch::async, [this, recording = std::move(recording), name = std::move(name),
                                               options] { return share(recording, name, options); });
    } catch (const std::system_error& thrown) {
        return tl::unexpected(failure_of(thrown));
    }
    return {};
}

std::optional<double> Sharing::progress() const {
    if (!job_.valid()) return std::nullopt;
    return static_cast<double>(progress_);
}

std::optional<Outcome<Sharing::Shared>> Sharing::result() {
    if (!job_.valid() || job_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return std::nullopt;
    return job_.get();
}

// Catches exceptions, because none may leave the thread.
Outcome<Sharing::Shared> Sharing::share(const std::string& recording, const std::string& name,
                                        const PageOptions& options) {
    lower_priority_of_thread();
    const auto parent = data_folder("shared");
    if (!parent) return tl::unexpected(parent.error());
    const auto folder = new_folder(*parent, name);
    if (!folder) return tl::unexpected(folder.error());
    Outcome<PageReport> page;
    try {
        page = write_into(*folder, recording, options);
    } catch (const std::exception& thrown) {  // such as out of memory
        page = tl::unexpected(failure_of(thrown));
    }
    if (page && !stop_) return Shared{*folder, *page};
    std::error_code error;
    for (const fs::path& left : {*folder / kPage, *folder / kRecording, *folder}) fs::remove(left, error);
    return tl::unexpected(page ? Failure{Failure::kMachine, "it was stopped"} : page.error());
}

Outcome<PageReport> Sharing::write_into(const fs::path& folder, const std::string& recording,
                                        const PageOptions& options) {
    if (auto written = write_text(folder / kRecording, recording); !written)
        return tl::unexpected(written.error());
    return write_page_(folder / kRecording, folder / kPage, options, &stop_, &progress_);
}

}  // namespace game
