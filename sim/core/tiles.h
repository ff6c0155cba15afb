#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/core/grid.h"

namespace sim {

// Tracks which parts of a world may change in the next sub-step, and which were written since something was
// last derived from them. A tile sleeps if no material flowed or came to rest in or near it. A sub-step would
// leave it bit-identical, so the sub-step skips it.
//
// A tile counts as written when it is opened for writing, whatever is then written. A sub-step opens the
// tiles that it sweeps, a command those under its disc, restore() and the plain step all of them.
struct Tiles {
    Tiles() = default;
    // Tiles of `width` by `height` vertices. The width is a multiple of 2 kRowPadding, so that a sweep has
    // room between two of them (sweep/sweep.h).
    Tiles(const Grid& grid, int width, int height);

    int width = 1, height = 1;
    int columns = 0, rows = 0;
    // Index of a tile in the arrays below.
    std::size_t number(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
    bool may_sleep = true;            // false: every sub-step sweeps all tiles
    std::vector<std::uint8_t> awake;  // columns × rows

    // Per tile: written since its mass was last counted (cleared by count_changed_mass); its mass at that
    // time, in quanta; written since it was last hashed (cleared by update_state_hash).
    struct Mass {
        std::int64_t standing = 0, rolling = 0;
    };
    std::vector<std::uint8_t> uncounted;
    std::vector<Mass> mass;
    std::vector<std::uint8_t> unhashed;
    // Written since whoever watches the world last looked (cleared by the watcher; there is at most one).
    std::vector<std::uint8_t> unseen;
    // Ground may have changed there since it was last smoothed (momentum/smooth_ground.h).
    std::vector<std::uint8_t> unsmoothed;

    // Opens tiles for writing; columns and rows of tiles, inclusive.
    void open(int first_column, int last_column, int first_row, int last_row);
    void open_all();

    // Opens the tiles of these vertices, inclusive, and wakes every tile that a change there can reach.
    void wake(int x0, int x1, int y0, int y1);
    void wake_all();

    // Call after a sub-step: keeps awake the active tiles and those that they can reach. `active`: per tile,
    // as Activity.
    void keep_awake(const std::vector<std::uint8_t>& active);

    // Sets tiles, inclusive, in one of the arrays, or in another one like them.
    void mark(std::vector<std::uint8_t>& tiles, int first_column, int last_column, int first_row,
              int last_row) const;
};

}  // namespace sim
