#include "sim/tiles.h"

#include <algorithm>

namespace sim {

Tiles::Tiles(const Grid& grid, int tile_width, int tile_height)
    : width(tile_width),
      height(tile_height),
      columns((grid.nx + width - 1) / width),
      rows((grid.ny + height - 1) / height),
      awake(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 1),
      changed(awake),
      mass(awake.size()) {
    CHECK(width > 0 && height > 0 && width % kRowPadding == 0);
}

void Tiles::wake_all() {
    std::fill(awake.begin(), awake.end(), std::uint8_t{1});
    std::fill(changed.begin(), changed.end(), std::uint8_t{1});
}

void Tiles::wake(int x0, int x1, int y0, int y1) {
    const int first_column = std::max(x0 / width - 1, 0), last_column = std::min(x1 / width + 1, columns - 1);
    const int first_row = std::max(y0 / height - 1, 0), last_row = std::min(y1 / height + 1, rows - 1);
    for (int row = first_row; row <= last_row; ++row)
        for (int column = first_column; column <= last_column; ++column) {
            const std::size_t tile = number(column, row);
            awake[tile] = changed[tile] = 1;
        }
}

void Tiles::keep_awake(const std::vector<std::uint8_t>& active) {
    std::fill(awake.begin(), awake.end(), std::uint8_t{!may_sleep});
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            if (active[number(column, row)]) wake(column * width, column * width, row * height, row * height);
}

}  // namespace sim
