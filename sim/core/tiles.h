#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/core/grid.h"

namespace sim {

// Which parts of a world may change in the next sub-step, and which were written since something was last
// derived from them. A tile falls asleep when nothing rolled and nothing came to rest in it and near it: a
// sub-step would leave it bit-identical, so it is left out.
//
// A tile counts as written as soon as it is opened for writing, whatever is then written into it: a sub-step
// opens the tiles that it sweeps, a command those under its disc, restore() and the plain step all of them.
struct Tiles {
    Tiles() = default;
    // Tiles of `width` by `height` vertices; width a whole multiple of 2 kRowPadding, so that a sweep finds
    // room between two of them (sweep/sweep.h).
    Tiles(const Grid& grid, int width, int height);

    int width = 1, height = 1;
    int columns = 0, rows = 0;
    // Where a tile stands in what follows.
    std::size_t number(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
    bool may_sleep = true;            // else every sub-step sweeps all tiles
    std::vector<std::uint8_t> awake;  // columns × rows

    // Of each tile: whether it was written since its mass was last counted (count_changed_mass clears it),
    // what it held then, in quanta, and whether it was written since it was last hashed (update_state_hash
    // clears it).
    struct Mass {
        std::int64_t standing = 0, rolling = 0;
    };
    std::vector<std::uint8_t> uncounted;
    std::vector<Mass> mass;
    std::vector<std::uint8_t> unhashed;

    // Opens tiles for writing; columns and rows of tiles, inclusive.
    void open(int first_column, int last_column, int first_row, int last_row);
    void open_all();

    // Opens what lies under these vertices, inclusive, and wakes whatever a change of it reaches.
    void wake(int x0, int x1, int y0, int y1);
    void wake_all();

    // After a sub-step: awake is what was active in it, and those around that this reaches. `active`: of each
    // tile, as Activity.
    void keep_awake(const std::vector<std::uint8_t>& active);

  private:
    void wake_tiles(int first_column, int last_column, int first_row, int last_row);  // inclusive
};

}  // namespace sim
