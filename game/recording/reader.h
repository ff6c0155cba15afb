#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "game/recording/format.h"

namespace game {

struct Recording {
    Header header;
    std::vector<TimedCommand> commands;  // sorted by tick
    std::vector<StateLine> states;       // sorted by tick
    std::optional<ClaimLine> claim;      // the last one
    std::optional<std::int64_t> end;     // ticks done; none if the recorder was cut off
    std::optional<std::string>
        warning;  // a torn last line, a missing end, or numbers that are not the recorded ones

    // The last tick known from the file: its end, or else the last tick that it names.
    std::int64_t last_tick() const;
};
// Checks that the file reaches a tick. Errors: it ends earlier (status 2).
Outcome<void> check_tick(const Recording& recording, std::int64_t tick, const std::string& name);

// Reads and checks a whole recording, in time and memory linear in the file, within
// game/base/limits.h. A torn last line and a missing end are warnings. Any other damage is
// an error that names the line, and so is a terrain that `memory` does not allow. A line
// that names a tick more than ticks_per_state after the last state line is damage, because
// states between them are missing. A fork may have no states before its parent's tick.
// The stream is seekable; error messages start with `name`.
Outcome<Recording> read_recording(std::istream& stream, const std::string& name, const Memory& memory = {});

}  // namespace game
