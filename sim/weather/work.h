#pragma once

#include <cstdint>
#include <vector>

#include "sim/core/grid.h"

namespace sim {
struct State;
}

namespace sim::weather {

// What an hour of weather works with, made once per world. Only what follows from natural ground is kept from one hour to
// the next, so that no hour depends on the ones that this program has seen.
struct Work {
    Work(const State& state, int threads);

    // Known from natural ground.
    Field<float> share;        // of a snowfall: 1, less on steep rock, more below it
    Field<float> mean_height;  // m above datum, of the ground within 100 m

    // Of the hour.
    Field<float> gradient_x, gradient_y;  // of the surface b + d, over 24 m or two cells
    Field<float> over;                    // m, how far a place is in the shade; then in the wake of the wind
    Field<float> wind;                    // of its speed high above the ground
    Field<float> stability;               // index S of the slab; kStable where none can release

    std::vector<std::int64_t> fallen, melted;  // quanta, of each thread
    struct Drifting {
        std::vector<std::int32_t> straight, aside;  // quanta that leave each vertex of a row
    };
    Drifting before, now;

    // Of a release: what happens to each vertex, and vertices in the order in which a crack reached them.
    std::vector<std::uint8_t> crack;
    std::vector<std::int32_t> cracked, piece;
};

}  // namespace sim::weather
