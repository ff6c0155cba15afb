#pragma once

#include <optional>

#include "sim/core/workers.h"
#include "sim/momentum/smooth_ground.h"
#include "sim/scratch.h"
#include "sim/stages/stage_watch.h"
#include "sim/sweep/sweeper.h"
#include "sim/weather/work.h"

namespace sim {

// Execution options of a step; they never affect results.
struct StepOptions {
    int threads = 1;     // ≥ 1
    bool plain = false;  // stage by stage over the fields (bcre/plain.h), as a mixed world always is
    InstructionSet instruction_set = best_instruction_set();  // of the sweep
    int tile_width = 64, tile_height = 32;                    // vertices; see Tiles
    bool tiles_may_sleep = true;
    bool last_tile_first = false;  // the order in which a thread sweeps its tiles
};

// The working memory of a step, made once per world so that a step allocates nothing. Keeps no state between
// sub-steps. The constructor replaces the state's tiles; all are awake.
struct Engine {
    explicit Engine(State& state, const StepOptions& options = {});

    StepOptions options;
    Workers workers;
    StageWatch watch;                       // of the plain step
    std::optional<Scratch<float>> scratch;  // of it
    std::optional<sweep::Sweeper> sweeper;
    std::optional<momentum::GroundSmoother> smoother;  // of the models with momentum
    std::optional<weather::Work> weather;              // of a world with weather
};

}  // namespace sim
