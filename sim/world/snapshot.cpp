#include "sim/world/snapshot.h"

#include <utility>

namespace sim {

namespace {

std::optional<Snapshot::Standing> standing_in(const State& s) {
    if (!s.things) return std::nullopt;
    return Snapshot::Standing{s.things->earth, s.first_slope,  s.things->forest,
                              s.things->water, s.things->list, s.things->budget};
}

void restore_things(const Snapshot& snapshot, State& s) {
    if (!snapshot.things && !s.things) return;
    Things& t = things_of(s);
    // None in the snapshot: as before the first.
    const Snapshot::Standing none{
        Field<float>(s.grid), t.natural_slope, Field<Stems>(s.grid), Field<float>(s.grid), {}};
    const Snapshot::Standing& then = snapshot.things ? *snapshot.things : none;
    t.earth = then.earth;
    t.earth_moved = moved_in(t.earth);
    t.forest = then.forest;
    t.water = then.water;
    t.list = then.list;
    t.budget = then.budget;
    t.unhashed = true;
    rebuild_wooded(t);
    rebuild_objects(s);
    for (int y = 0; y < s.grid.ny; ++y)
        for (int x = 0; x < s.grid.nx; ++x) set_bedrock(s, x, y);
    continue_bedrock(s, s.params);
    s.first_slope = then.first_slope;
    find_walls(s, std::exchange(t.stale, VertexBox{}));
    s.block_hashes.bedrock_is_stale = true;
}

}  // namespace

Snapshot take_snapshot(const State& s) {
    return {s.params,      s.depth,        s.rolling, s.velocity_x,       s.velocity_y,
            s.first_depth, s.smooth_depth, s.tick,    s.running_commands, s.ledger,
            s.mixture,     s.weather,      s.limited, standing_in(s)};
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
    s.ledger = snapshot.ledger;
    s.mixture = snapshot.mixture;
    s.weather = snapshot.weather;
    s.limited = snapshot.limited;
    restore_things(snapshot, s);
    s.still_ticks = 0;  // known again after two ticks
    s.tiles.wake_all();
}

}  // namespace sim
