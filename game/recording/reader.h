#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "game/recording/format.h"

namespace game {

struct Recording {
    Header header;
    std::vector<TimedCommand> commands;  // in order of their ticks
    std::vector<StateLine> states;       // in order of their ticks
    std::optional<std::int64_t> end;     // ticks done; none if the recorder was cut off
    std::optional<std::string> warning;  // a torn last line, a missing end

    // Up to where the file says anything: its end, or the last tick that it names.
    std::int64_t last_tick() const;
};
// Whether the file says anything about a tick. Errors: it ends earlier (status 2).
Outcome<void> check_tick(const Recording& recording, std::int64_t tick, const std::string& name);

// Reads and checks a whole recording, in time and memory linear in the file, within game/base/limits.h. A
// torn last line and a missing end are a warning; any other damage is an error that names the line, and so is
// a terrain that `memory` does not allow. A line that names a tick more than ticks_per_state after the last
// state line is damage: the states between are missing. A fork may have none before its parent's tick.
Outcome<Recording> read_recording(const std::filesystem::path& path, const Memory& memory = {});
// The same from what can be gone back in; `name` is what complaints begin with.
Outcome<Recording> read_recording(std::istream& stream, const std::string& name, const Memory& memory = {});

}  // namespace game
