#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/world/state.h"

namespace sim {

// The part of a state that changes in a fixed world: a plain value. Restoring it into a state of the same
// world gives the same hash and a bit-identical future.
struct Snapshot {
    Params params;
    Field<float> depth, rolling, velocity_x, velocity_y, first_depth, smooth_depth;  // as in State
    std::int64_t tick = 0;
    std::vector<RunningCommand> running_commands;
    Ledger ledger;
    std::optional<Mixture> mixture;
    std::optional<Weather> weather;
    std::int64_t limited = 0;

    struct Standing {
        Field<float> earth, first_slope;
        Field<Stems> forest;
        Field<float> water;
        std::vector<Thing> list;
        std::int64_t budget = -1;
    };
    std::optional<Standing> things;
};

Snapshot take_snapshot(const State& state);
void restore(const Snapshot& snapshot,
             State& state);  // `state` must be of the world the snapshot was taken of

}  // namespace sim
