#pragma once

#include <filesystem>

#include "game/app/shown_runs.h"
#include "game/scene/scene.h"

namespace game {

// The results of an ensemble, for a window. Errors: those of read_ensemble_spec() and read_ensemble(); it maps no probability.
Outcome<Runs> runs_of_ensemble(const std::filesystem::path& spec, const std::filesystem::path& folder,
                               const Overrides& overrides);

}  // namespace game
