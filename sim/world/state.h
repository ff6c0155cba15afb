#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/grid.h"
#include "sim/core/tiles.h"
#include "sim/world/command.h"
#include "sim/world/layers.h"
#include "sim/world/ledger.h"
#include "sim/world/mixture.h"
#include "sim/world/params.h"
#include "sim/world/state_hash.h"
#include "sim/world/things.h"
#include "sim/world/weather.h"

namespace sim {

// A running command: a pour, dig, wet or drain may last longer than its first tick.
struct RunningCommand {
    Command command;
    std::int64_t first_tick = 0;
    bool operator==(const RunningCommand&) const = default;
};

// All that a step changes, and the ground under it. A plain value: copy it to keep it.
struct State : Layers<float> {
    Params params;  // current parameters, including those set by commands

    double datum = 0;  // m, height of b = 0 above the terrain's zero; bedrock is kept small so that slopes
                       // keep their digits

    std::int64_t tick = 0;                         // ticks done
    std::vector<RunningCommand> running_commands;  // running, in the order in which they were given
    Ledger ledger;                                 // where the mass is

    std::optional<Mixture> mixture;  // of a world of two materials
    std::optional<Things>
        things;  // of a world where anything stands, was sculpted or is wet; or that has weather
    std::optional<Weather> weather;  // of a world that has any

    // Vertices times sub-steps whose speed passed greatest_speed and was cut to it, since the world began.
    // Not part of the hash, because it follows from the rest.
    std::int64_t limited = 0;
    // voellmy: consecutive ticks at whose end no layer had a velocity, at most 2. Not part of the hash.
    int still_ticks = 0;

    // What is known about the above; never part of the hash, because it changes no bit.
    Tiles tiles;
    BlockHashes block_hashes;
};

// Nothing rolls and nothing is being poured or dug: with no further command every later tick leaves the same
// fields. In voellmy, whose layer is not deposited, nothing moved for two ticks. In a world with weather its calendar is
// over, too.
bool at_rest(const State& state);

// The next tick without commands is an hour of weather: nothing rolls or is being poured or dug, and the calendar is not
// over.
bool is_calm(const State& state);

// A flow is under way, or about to begin or to be poured: the world neither rests nor lets weather pass.
inline bool flows(const State& state) {
    return !at_rest(state) && !is_calm(state);
}

// None in a world without weather.
inline const Weather* weather_of(const State& state) {
    return state.weather ? &*state.weather : nullptr;
}

// Counts still_ticks. Call at the end of a tick.
void count_still_ticks(State& state);

// Read-only view that everything outside sim gets. Valid as long as the state is.
struct View {
    const Grid& grid;
    const Field<float>& bedrock;     // m above datum
    const Field<float>& depth;       // m
    const Field<float>& rolling;     // m
    const Field<float>& velocity_x;  // m/s
    const Field<float>& velocity_y;  // m/s
    const Field<Site>& site;
    const Field<float>* smooth_depth;  // m; of the smoothed ground, along which a layer moves; null in bcre
    const Mixture* mixture;            // null in a world of one material
    const Things* things;              // null in a world without things
    const Tiles& tiles;                // where anything may move; empty without an engine
    double datum;       // m; height above the terrain's zero is datum + bedrock + depth + rolling
    std::int64_t tick;  // ticks done
};

// The same world on another bedrock, which outlives the view.
inline View on_bedrock(const View& v, const Field<float>& bedrock) {
    return {v.grid,         bedrock,   v.depth,  v.rolling, v.velocity_x, v.velocity_y, v.site,
            v.smooth_depth, v.mixture, v.things, v.tiles,   v.datum,      v.tick};
}

inline View view(const State& s) {
    return {s.grid,
            s.bedrock,
            s.depth,
            s.rolling,
            s.velocity_x,
            s.velocity_y,
            s.site,
            has_momentum(s.params.model) ? &s.smooth_depth : nullptr,
            s.mixture ? &*s.mixture : nullptr,
            s.things ? &*s.things : nullptr,
            s.tiles,
            s.datum,
            s.tick};
}

}  // namespace sim
