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

// When a world without a window stops.
struct Until {
    std::optional<std::int64_t> tick;        // after so many ticks
    bool rest = false;                       // or when nothing moves and no command is left
    std::int64_t most_ticks = 60 * 60 * 60;  // in any case

    static Until after(std::int64_t ticks) { return {ticks, false, ticks}; }
    static Until at_rest() { return {std::nullopt, true}; }
};

// What is watched on the way; each may be missing. None of it changes the world.
struct Watchers {
    Gallery* gallery = nullptr;
    std::int64_t ticks_per_picture = 60;  // ≥ 1; the first and the last state are drawn too
    PerfLog* perf = nullptr;
    std::function<void(const Session&)> after_tick;
};

// Plays a session, with the commands from its tick on, at their ticks. Returns whether it stopped for the
// reason that was asked for, false where most_ticks came first.
Outcome<bool> play_headless(Session& session, std::span<const TimedCommand> commands, const Until& until,
                            const Watchers& watchers, const std::string& what);

}  // namespace game
