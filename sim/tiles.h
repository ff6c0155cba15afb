#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/grid.h"

namespace sim {

// Which parts of a world may change in the next sub-step. A tile falls asleep when nothing rolled and nothing
// came to rest in it and near it: a sub-step would leave it as it is, to the bit, so it is left out.
// Whoever changes a state otherwise than by a step wakes what he changed.
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
    bool may_sleep = true;            // else all is reckoned, counted and hashed anew each time
    std::vector<std::uint8_t> awake;  // columns × rows

    // Of each tile: whether anything in it may have changed since mass was counted last, and what it had
    // then, in quanta; and whether since the state was hashed last.
    struct Mass {
        std::int64_t standing = 0, rolling = 0;
    };
    std::vector<std::uint8_t> changed;
    std::vector<Mass> mass;
    std::vector<std::uint8_t> unhashed;

    void wake_all();
    void wake(int x0, int x1, int y0, int y1);  // vertices, inclusive: what is changed, and what that reaches

    // After a sub-step: awake is what was active in it, and those around that this reaches. `active`: of each
    // tile, as Activity.
    void keep_awake(const std::vector<std::uint8_t>& active);

  private:
    void wake_tiles(int first_column, int last_column, int first_row, int last_row);  // inclusive
};

}  // namespace sim
