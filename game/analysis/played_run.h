#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/analysis/best_runs.h"
#include "game/analysis/score.h"
#include "game/base/outcome.h"
#include "game/scene/memory.h"
#include "game/session/run_extent.h"

namespace game {

// The score and the extent of a recorded run, found by playing it. Errors: the file cannot be read, it is of another
// challenge than the one with this identity, a rule of the challenge is broken, or it was stopped.
struct PlayedRun {
    Score score;
    RunExtent extent;
};
Outcome<PlayedRun> play_run(const std::filesystem::path& file, const std::string& challenge,
                            const Memory& memory, const std::atomic<bool>& stopped);

// The best of these runs, the best first, of those whose score is the one that the name of their file claims; and, a sentence
// each, what is wrong with those before it. Nothing if it was stopped.
struct PlayedRuns {
    std::optional<PlayedRun> best;
    std::vector<std::string> faults;
};
PlayedRuns play_best_run(const std::vector<BestRun>& runs, const std::string& challenge, const Memory& memory,
                         const std::atomic<bool>& stopped);

}  // namespace game
