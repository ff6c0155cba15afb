#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "game/base/job.h"
#include "game/base/outcome.h"
#include "game/share/share_recording.h"

namespace game {

// Writes the page and the recording of a slide into a new folder, on a thread of low priority. One slide at a
// time. Use it from one thread.
class Sharing {
  public:
    static constexpr const char *kPage = "slide.html", *kRecording = "slide.couloir";

    using WritePage = std::function<decltype(write_page_of)>;
    explicit Sharing(WritePage write_page = write_page_of) : write_page_(std::move(write_page)) {}

    // Starts; nothing must be under way. `recording`: the text of the whole file. `name`: of the new folder in
    // couloir/shared of the XDG data folder. Errors: the system cannot start a thread.
    Outcome<void> begin(std::string recording, std::string name, PageOptions options);
    // Of the page, 0 to 1; nothing unless a slide is under way.
    std::optional<double> progress() const;

    struct Shared {
        std::filesystem::path folder;
        PageReport page;
    };
    // How it ended, once; nothing while it is under way. Errors: a folder or file cannot be written, or those
    // of write_page_of(); then nothing remains.
    std::optional<Outcome<Shared>> result() { return job_.result(); }

  private:
    Outcome<Shared> share(const std::string& recording, const std::string& name, const PageOptions& options,
                          const std::atomic<bool>& stopped);
    Outcome<PageReport> write_into(const std::filesystem::path& folder, const std::string& recording,
                                   const PageOptions& options, const std::atomic<bool>& stopped);

    WritePage write_page_;
    std::atomic<float> progress_ = 0;
    Job<Shared> job_;
};

}  // namespace game
