#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "game/analysis/best_runs.h"
#include "game/base/job.h"
#include "game/base/outcome.h"
#include "game/controls/catalogue.h"
#include "game/scene/scenario.h"

namespace game {

// The best runs that the window shows: those of the challenge that is open, and the best one of each that ships. To tell a
// shipped challenge from another of its name its scene must be loaded, which is done on a thread of low priority, and
// only if runs of that name exist.
class BestList {
  public:
    // Another world begins, with or without a goal.
    void open(const Scenario& scenario);
    // Of the open challenge, the best first.
    const std::vector<BestRun>& runs() const { return runs_; }
    // Keeps a run of the open challenge (keep_run()).
    Outcome<void> keep(const Score& score, std::uint64_t hash, std::string_view recording);

    // Call once per frame: tells each scene of the catalogue its best run, as soon as that is known.
    void mark(std::vector<Catalogue::Entry>& scenes);

  private:
    using Folders = std::map<std::string, std::filesystem::path>;  // by the name of a shipped scene
    void look_for_folders(const std::vector<Catalogue::Entry>& scenes);

    std::filesystem::path open_;  // folder of the open challenge; empty: none
    std::vector<BestRun> runs_;
    Folders folders_;
    bool outdated_ = true;  // the marks
    Job<Folders> job_;
};

}  // namespace game
