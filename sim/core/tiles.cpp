#include "sim/core/tiles.h"

#include <algorithm>

#include "sim/core/activity.h"

namespace sim {

Tiles::Tiles(const Grid& grid, int tile_width, int tile_height)
    : width(tile_width),
      height(tile_height),
      columns((grid.nx + width - 1) / width),
      rows((grid.ny + height - 1) / height),
      awake(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 1),
      uncounted(awake),
      mass(awake.size()),
      unhashed(awake),
      unseen(awake),
      unsmoothed(awake) {
    CHECK(width > 0 && height > 0 && width % (2 * kRowPadding) == 0);
}

void Tiles::open(int first_column, int last_column, int first_row, int last_row) {
    mark(uncounted, first_column, last_column, first_row, last_row);
    mark(unhashed, first_column, last_column, first_row, last_row);
    mark(unseen, first_column, last_column, first_row, last_row);
}

void Tiles::open_all() {
    open(0, columns - 1, 0, rows - 1);
}

void Tiles::wake_all() {
    open_all();
    std::fill(unsmoothed.begin(), unsmoothed.end(), std::uint8_t{1});
    std::fill(awake.begin(), awake.end(), std::uint8_t{1});
}

void Tiles::wake(int x0, int x1, int y0, int y1) {
    if (awake.empty()) return;  // a state without an engine has no tiles
    open(x0 / width, x1 / width, y0 / height, y1 / height);
    mark(unsmoothed, x0 / width, x1 / width, y0 / height, y1 / height);
    mark(awake, std::max(x0 - kReach, 0) / width, std::min((x1 + kReach) / width, columns - 1),
         std::max(y0 - kReach, 0) / height, std::min((y1 + kReach) / height, rows - 1));
}

void Tiles::mark(std::vector<std::uint8_t>& tiles, int first_column, int last_column, int first_row,
                 int last_row) const {
    for (int row = first_row; row <= last_row; ++row)
        for (int column = first_column; column <= last_column; ++column) tiles[number(column, row)] = 1;
}

void Tiles::keep_awake(const std::vector<std::uint8_t>& active) {
    std::transform(active.begin(), active.end(), unsmoothed.begin(), unsmoothed.begin(),
                   [](std::uint8_t where, std::uint8_t was) { return std::uint8_t(where != kQuiet || was); });
    if (!may_sleep) return;
    std::fill(awake.begin(), awake.end(), std::uint8_t{0});
    const int beside = (kReach + height - 1) / height;  // rows of tiles; a column is wider than kReach
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const std::uint8_t where = active[number(column, row)];
            if (where == kQuiet) continue;
            mark(awake, where & kNearWest ? std::max(column - 1, 0) : column,
                 where & kNearEast ? std::min(column + 1, columns - 1) : column,
                 where & kNearSouth ? std::max(row - beside, 0) : row,
                 where & kNearNorth ? std::min(row + beside, rows - 1) : row);
        }
}

}  // namespace sim
