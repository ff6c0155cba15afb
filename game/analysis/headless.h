#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "game/analysis/gallery.h"
#include "game/base/outcome.h"
#include "game/session/perf_log.h"
#include "game/session/session.h"

namespace game {

// When to stop a world without a window.
struct Until {
    // Or earlier, once no command is left or running:
    enum class Rest {
        kNone,
        // and the try, if there is a goal, has ended, and the kinetic energy has fallen to 1 % of its greatest since the
        // last command; or as kStill
        kEnergy,
        kStill,  // and nothing moves
    };
    std::optional<std::int64_t> tick;  // after this many ticks
    Rest rest = Rest::kNone;
    std::int64_t most_ticks = 60 * 60 * 60;  // upper limit

    // As AvaFrame's com1DFA ends a run (stopCrit); what moves on is a creep whose end nobody needs to wait for.
    static constexpr std::int64_t kEnergyFallsBy = 100;

    static Until after(std::int64_t ticks) { return {ticks, Rest::kNone, ticks}; }
    // When nothing moves, or `most_ticks` after this tick.
    static Until still(std::int64_t earliest = 0) {
        return {std::nullopt, Rest::kStill, earliest + Until().most_ticks};
    }
};

// Why a run stopped.
enum class Ended {
    kTick,    // at its tick
    kEnergy,  // as Until::Rest::kEnergy
    kStill,   // nothing moves
    kLimit,   // it reached most_ticks first
};
std::string_view to_string(Ended ended);  // "time", "energy", "rest", "limit"

// Optional observers of the run. None of them changes the world.
struct Watchers {
    Gallery* gallery = nullptr;
    std::int64_t ticks_per_picture = 60;  // ≥ 1; the first and the last state are drawn too
    PerfLog* perf = nullptr;
    std::function<void(const Session&)> after_tick;
    // After each tick too. Its error ends the run.
    std::function<Outcome<void>(const Session&)> keep;
};

// What is done at the start of a tick, of commands sorted by tick.
std::vector<sim::Command> commands_of_tick(std::span<const TimedCommand> commands, std::int64_t tick);

// Plays a session, with the commands from its tick on. `what`: of the progress bar; empty: it has none.
Outcome<Ended> play_headless(Session& session, std::span<const TimedCommand> commands, const Until& until,
                             const Watchers& watchers, const std::string& what);

}  // namespace game
