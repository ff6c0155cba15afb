#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "game/analysis/gallery.h"
#include "game/base/outcome.h"
#include "game/session/perf_log.h"
#include "game/session/session.h"

namespace game {

// When to stop a world without a window.
struct Until {
    std::optional<std::int64_t> tick;        // after this many ticks
    bool rest = false;                       // or when nothing moves and no command is left
    std::int64_t most_ticks = 60 * 60 * 60;  // upper limit

    static Until after(std::int64_t ticks) { return {ticks, false, ticks}; }
    // At rest, or `most_ticks` after this tick.
    static Until at_rest(std::int64_t earliest = 0) {
        return {std::nullopt, true, earliest + Until().most_ticks};
    }
};

// Optional observers of the run. None of them changes the world.
struct Watchers {
    Gallery* gallery = nullptr;
    std::int64_t ticks_per_picture = 60;  // ≥ 1; the first and the last state are drawn too
    PerfLog* perf = nullptr;
    std::function<void(const Session&)> after_tick;
    // After each tick too. Its error ends the run.
    std::function<Outcome<void>(const Session&)> keep;
};

// Plays a session, with the commands from its tick on. Returns whether it stopped as requested; false if it
// reached most_ticks first.
Outcome<bool> play_headless(Session& session, std::span<const TimedCommand> commands, const Until& until,
                            const Watchers& watchers, const std::string& what);

}  // namespace game
