#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "game/analysis/score.h"
#include "game/base/outcome.h"
#include "game/recording/reader.h"
#include "game/scene/scenario.h"

namespace game {

// A try at a challenge that met all needs, kept as the recording of it, which ends where the try ended.
struct BestRun {
    std::int64_t score = 0;
    int medal = 0;           // 0 none to 3 gold
    std::string when;        // local time, "2026-11-26 12:58:00"
    std::uint64_t hash = 0;  // of its last state
    std::filesystem::path file;
};

// The best runs of a challenge are the recordings in its folder. Each has its place in its name, such as
// 1465_gold_2026-11-26_12-58-00_0123456789abcdef.couloir: there is no table beside them that could be damaged or contradict
// them, and windows that add at the same time lose nothing. Other files in the folder are left alone. A name only claims a
// score; Referee proves it.
inline constexpr std::size_t kMostBestRuns = 10;

// The folder of a scenario's challenge: couloir/best/SCENE-IDENTITY in the XDG data folder. The identity is
// challenge_id(). Errors: neither XDG_DATA_HOME nor HOME is set.
Outcome<std::filesystem::path> best_runs_folder(const Scenario& scenario);

// The best first: by medal, then by score, then the earlier; at most kMostBestRuns, each run once. None if there is no
// such folder.
std::vector<BestRun> best_runs(const std::filesystem::path& folder);

// What keep_run() keeps of a recording that may go on after its try: a fork of it up to the tick in which the try ended, so that
// its origin is named. `name`: of the recording; `at_end`: the state in that tick. Errors: as Recorder::fork().
Outcome<std::string> recording_of_try(const Recording& of, const std::string& name, const Score& score,
                                      const StateLine& at_end);

// Keeps a run if it is among the best, and removes what no longer is. `hash`: of the state in which the try ended;
// `recording`: the text of the whole file. Errors: the file cannot be written, and then nothing has changed.
Outcome<void> keep_run(const std::filesystem::path& folder, const Score& score, std::uint64_t hash,
                       std::string_view recording);

}  // namespace game
