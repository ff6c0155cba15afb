#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "files/appended_file.h"
#include "game/base/outcome.h"
#include "game/ensemble/member.h"

namespace game {

// The finished members of an ensemble, a line each in the order in which they finished, in a file that survives a
// `kill -9` up to its last whole line. One process writes it at a time.
class Journal {
  public:
    // Opens or begins the journal of this ensemble. Errors: another process writes it (status 3); it is of another
    // ensemble, or damaged before its last line (status 2); it cannot be written (status 3).
    static Outcome<Journal> open(const std::filesystem::path& file, const EnsembleSpec& spec);

    // Flushed to the system before it returns. A member that it has already must have come to the same: else status 1.
    Outcome<void> add(const Member& member);
    const std::map<std::int64_t, Member>& members() const { return members_; }
    // Bytes of a line that was cut off by the end of an earlier process, and are gone.
    std::size_t dropped() const { return dropped_; }

  private:
    Journal(std::filesystem::path path, files::AppendedFile file)
        : path_(std::move(path)), file_(std::move(file)) {}
    Outcome<void> read(const std::string& text, const EnsembleSpec& spec);

    std::filesystem::path path_;
    files::AppendedFile file_;
    std::map<std::int64_t, Member> members_;
    std::size_t dropped_ = 0;
};

}  // namespace game
