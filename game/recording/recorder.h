#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "files/growing_file.h"
#include "game/base/outcome.h"
#include "game/recording/chain.h"
#include "game/recording/format.h"
#include "game/recording/reader.h"

namespace game {

// Writes a recording as it happens. Every line is passed to the system before the world continues, so a
// recording survives a `kill -9` up to its last whole line. The file is locked, so that no other process
// records into it. Errors of all calls: the file cannot be written (status 3); whole lines remain.
//
// A file of this name is replaced when the first line after the header is written, and kept beside the new one until
// delete_replaced(). With kWhenDone nothing is seen of the new one, and nothing replaced, before the end line. A
// recorder that writes no line after its header leaves everything as it was.
class Recorder {
  public:
    using Replaces = files::GrowingFile::Replaces;

    // Creates the file; makes its folder.
    static Outcome<Recorder> create(const std::filesystem::path& path, const Scenario& scenario,
                                    std::optional<Parent> parent = std::nullopt);
    static Outcome<Recorder> create(const std::filesystem::path& path, const Header& header,
                                    Replaces replaces = Replaces::kAsItGrows);

    // Creates a file that continues from `of` at `tick`. It includes everything in `of` up to there, except
    // states of another version of the physics. `name`: the name of `of`. Errors: without these states, more
    // than kMostTicksOfParent ticks would lie before the first one, and no reader would accept the file
    // (status 2).
    static Outcome<Recorder> fork(const std::filesystem::path& path, const Recording& of,
                                  const std::string& name, std::int64_t tick);

    Outcome<void> command(const TimedCommand& command);
    Outcome<void> state(const StateLine& line);
    Outcome<void> claim(const ClaimLine& line);
    Outcome<void> end(std::int64_t tick);

    // The text of the file so far as if it ended at `tick`, with a last state line if there is one; the file goes
    // on. Errors: it is a device or a pipe, or it cannot be read.
    Outcome<std::string> copy_ended_at(std::int64_t tick, const StateLine* last) const;

    // A position in the file to return to.
    struct Mark {
        std::int64_t bytes = 0;
        std::int64_t last_state = -1;
        Chain chain;
    };
    Mark mark() const { return mark_; }
    // Removes all lines since `mark`.
    Outcome<void> rewind(const Mark& mark);

    // Tick of the last state written; −1 if there is none.
    std::int64_t last_state() const { return mark_.last_state; }
    const std::filesystem::path& path() const { return path_; }
    // Where the recording is that this one replaced, while it is kept.
    const std::optional<std::filesystem::path>& replaced() const { return to_.kept(); }
    void delete_replaced() { to_.delete_kept(); }

  private:
    explicit Recorder(std::filesystem::path path) : path_(std::move(path)) {}
    Outcome<void> open(Replaces replaces);
    Outcome<void> write_line();  // closes line_, writes and empties it
    Outcome<void> add_line();    // the same after the header
    Outcome<void> appear();

    std::filesystem::path path_;
    files::GrowingFile to_;
    Replaces replaces_ = Replaces::kAsItGrows;
    Mark mark_;         // after what was written
    std::string line_;  // reused to avoid allocation
};

}  // namespace game
