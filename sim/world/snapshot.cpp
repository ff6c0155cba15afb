#include "sim/world/snapshot.h"

namespace sim {

Snapshot take_snapshot(const State& s) {
    return {s.params,      s.depth,        s.rolling, s.velocity_x,       s.velocity_y,
            s.first_depth, s.smooth_depth, s.tick,    s.running_commands, s.seed,
            s.ledger,      s.mixture,      s.limited};
}

void restore(const Snapshot& snapshot, State& s) {
    CHECK(snapshot.depth.nx() == s.grid.nx && snapshot.depth.ny() == s.grid.ny);
    s.params = snapshot.params;
    s.depth = snapshot.depth;
    s.rolling = snapshot.rolling;
    s.velocity_x = snapshot.velocity_x;
    s.velocity_y = snapshot.velocity_y;
    s.first_depth = snapshot.first_depth;
    s.smooth_depth = snapshot.smooth_depth;
    s.tick = snapshot.tick;
    s.running_commands = snapshot.running_commands;
    s.seed = snapshot.seed;
    s.ledger = snapshot.ledger;
    s.mixture = snapshot.mixture;
    s.limited = snapshot.limited;
    s.still_ticks = 0;  // known again after two ticks
    s.tiles.wake_all();
}

}  // namespace sim
