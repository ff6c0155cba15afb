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

// What the text of a journal has.
struct JournalText {
    std::map<std::int64_t, Member> members;
    std::size_t torn = 0;    // bytes of a last line without an end
    bool has_begun = false;  // has its first line
};
// Errors: it is of another ensemble, or damaged before its last line (status 2), with `name` and line.
Outcome<JournalText> read_journal(const std::string& text, const std::string& name, const EnsembleSpec& spec);

// The finished members of an ensemble, a line each in the order in which they finished, in a file that survives a
// `kill -9` up to its last whole line. One process writes it at a time.
class Journal {
  public:
    // Opens or begins the journal of this ensemble. Errors: those of read_journal(); another process writes it, or it cannot
    // be written (status 3).
    static Outcome<Journal> open(const std::filesystem::path& file, const EnsembleSpec& spec);

    // Flushed to the system before it returns. A member that it has already must have come to the same: else status 1.
    Outcome<void> add(const Member& member);
    const std::map<std::int64_t, Member>& members() const { return read_.members; }
    // Bytes of a line that was cut off by the end of an earlier process, and are gone.
    std::size_t dropped() const { return read_.torn; }

  private:
    Journal(std::filesystem::path path, files::AppendedFile file, JournalText read)
        : path_(std::move(path)), file_(std::move(file)), read_(std::move(read)) {}

    std::filesystem::path path_;
    files::AppendedFile file_;
    JournalText read_;  // and what was added since
};

}  // namespace game
