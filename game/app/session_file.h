#pragma once

#include <filesystem>
#include <optional>
#include <utility>

#include "game/base/outcome.h"

namespace game {

// The file that the session in the window is written to. If nothing was done in it, the file does not remain, unless
// somebody counts on it: it was asked for with --record, or a screenshot names it.
class SessionFile {
  public:
    // The next session that can be recorded is to be written to `path`; nothing: to a file of the recordings folder.
    void want(std::optional<std::filesystem::path> path) { wanted_ = std::move(path); }
    const std::optional<std::filesystem::path>& wanted() const { return wanted_; }

    // A session begins, and is written to `path`; nothing while a recording is watched, or if there can be no file.
    void begin(std::optional<std::filesystem::path> path);
    const std::optional<std::filesystem::path>& path() const { return path_; }
    void keep() { keeps_ = true; }
    bool remains(bool touched) const { return path_ && (keeps_ || touched); }
    // The session goes on without it. A file that nobody asked for is optional: that none could be created is no failure.
    void stop(const Failure& failure);
    // Call once the file is closed: deletes it if it does not remain.
    void end(bool touched);

    // Why a file of this or of an earlier session could not be written completely; the first failure.
    const std::optional<Failure>& failure() const { return failure_; }

  private:
    std::optional<std::filesystem::path> path_, wanted_;
    bool keeps_ = false;
    std::optional<Failure> failure_;
};

}  // namespace game
