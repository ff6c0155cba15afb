#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "files/descriptor.h"
#include "game/base/outcome.h"
#include "game/recording/chain.h"
#include "game/recording/format.h"
#include "game/recording/reader.h"

namespace game {

// Writes a recording as it happens: every line is handed to the system before the world goes on, so that what
// was done survives a `kill -9` up to its last whole line. The file is locked: nobody else records into it.
// Errors of all calls: the file cannot be written (status 3); whole lines stay.
class Recorder {
  public:
    // Begins the file, replacing any that has this name; makes its folder.
    static Outcome<Recorder> create(const std::filesystem::path& path, const Scenario& scenario,
                                    std::optional<Parent> parent = std::nullopt);
    static Outcome<Recorder> create(const std::filesystem::path& path, const Header& header);

    // Begins a file that goes on from `of` at `tick`, and has all that `of` tells up to there; states of
    // another version of the physics left out. `name`: by which `of` is known.
    static Outcome<Recorder> fork(const std::filesystem::path& path, const Recording& of,
                                  const std::string& name, std::int64_t tick);

    Outcome<void> command(const TimedCommand& command);
    Outcome<void> state(const StateLine& line);
    Outcome<void> end(std::int64_t tick);

    // A place in the file to come back to.
    struct Mark {
        std::int64_t bytes = 0;
        std::int64_t last_state = -1;
        Chain chain;
    };
    Mark mark() const { return mark_; }
    // Takes back all lines since `mark`, as if they had never been.
    Outcome<void> rewind(const Mark& mark);

    // Tick of the last state that was written; −1: none yet.
    std::int64_t last_state() const { return mark_.last_state; }
    const std::filesystem::path& path() const { return path_; }

  private:
    struct Opened {
        files::Descriptor file;
        bool regular = false;  // else a device or a pipe, of which nothing can be taken back
    };
    static Outcome<Opened> open_alone(const std::filesystem::path& path);
    Recorder(std::filesystem::path path, Opened&& to) : path_(std::move(path)), to_(std::move(to)) {}
    Outcome<void> write_line();  // closes line_, writes and empties it

    std::filesystem::path path_;
    Opened to_;
    Mark mark_;         // after what was written
    std::string line_;  // kept for its memory
};

}  // namespace game
