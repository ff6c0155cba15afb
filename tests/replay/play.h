#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "game/analysis/headless.h"
#include "game/files/assets.h"
#include "game/recording/recording_file.h"
#include "game/session/session.h"

// Plays shipped recordings again.

namespace game::test {

inline Recording open(const std::string& name) {
    const auto path = find_asset(AssetKind::kRecording, name);
    if (!path) throw std::runtime_error(path.error().sentence);
    auto recording = read_recording(*path);
    if (!recording) throw std::runtime_error(recording.error().sentence);
    return std::move(*recording);
}

// Plays this many ticks. `look` is called at the start and after each tick.
inline void play(const Recording& recording, int threads, std::int64_t ticks,
                 const std::function<void(const Session&)>& look) {
    auto session =
        Session::begin(recording.header.scenario, sim::StepOptions{.threads = threads}, std::nullopt).value();
    look(session);
    Until until;
    until.tick = until.most_ticks = ticks;
    Watchers watchers;
    watchers.after_tick = look;
    play_headless(session, recording.commands, until, watchers, "").value();
}

}  // namespace game::test
