#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "game/analysis/made_challenge.h"
#include "game/base/job.h"
#include "game/base/outcome.h"
#include "render/pictures/picture.h"

namespace game {

// Makes a challenge of what was done (make_challenge()) in the folder of the user's own, on a thread of low priority. One
// at a time. Use it from one thread.
class ChallengeMaker {
  public:
    // Starts; nothing must be under way. `picture`: of what was done, small. Errors: the system cannot start a thread.
    Outcome<void> begin(Scenario scenario, History history, const sim::StepOptions& options,
                        std::optional<render::Picture> picture);
    bool is_busy() const { return job_.is_busy(); }

    struct Made {
        std::filesystem::path file;
        std::int64_t gold = 0;
    };
    // How it ended, once; nothing while it is under way.
    std::optional<Outcome<Made>> result() { return job_.result(); }
    const std::optional<render::Picture>& picture() const { return picture_; }  // as begun

  private:
    std::optional<render::Picture> picture_;
    Job<Made> job_;
};

}  // namespace game
