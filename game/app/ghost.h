#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/analysis/best_runs.h"
#include "game/analysis/played_run.h"
#include "game/base/job.h"
#include "game/scene/memory.h"
#include "game/scene/scenario.h"

namespace game {

// What the best run of a challenge had reached at the same time of its try. It is found on a thread of low priority, by
// playing its recording again: a run whose score is not the one that its name claims is left out, and the next one is
// tried. A view: it changes neither a world nor a recording.
class Ghost {
  public:
    // A try at the challenge of this scenario begins; `runs` are those so far, the best first. If the best one is the
    // same as before, nothing is played again. There is no ghost without a run, or if another world does not fit into
    // `memory`.
    void follow(const Scenario& scenario, const std::vector<BestRun>& runs, const Memory& memory);

    // Call once per frame: `ticks` since the user's first action, or since tick 0 of a challenge with events; below 0:
    // there was none yet.
    void see(std::int64_t ticks);
    // One value per vertex, row 0 the south: 255 where the ghost had been by then, else 0. Empty if there is none.
    std::span<const std::uint8_t> inside() const { return inside_; }
    // Another one for each change of inside(); 0 if that is empty.
    std::int64_t version() const { return inside_.empty() ? 0 : version_; }

    // Why a run was left out: a sentence, once.
    std::optional<std::string> fault();

  private:
    std::filesystem::path followed_;  // file of the best run; empty: there is none
    Job<PlayedRuns> job_;
    PlayedRuns found_;
    std::int64_t step_ = -1;  // of what inside_ has
    std::vector<std::uint8_t> inside_, next_;
    std::int64_t version_ = 0;
};

}  // namespace game
