#pragma once

#include <algorithm>
#include <cmath>

#include "sim/core/angle.h"
#include "sim/core/grid.h"

namespace sim::weather {

// A straight stream across the grid. It reaches a vertex from two that lie upstream: one straight along x or y, whichever
// the stream follows more, and one diagonally, aside.
struct Stream {
    // `to`: unit vector along it.
    Stream(const Grid& grid, Direction to)
        : dx(to.x >= 0 ? 1 : -1), dy(to.y >= 0 ? 1 : -1), along_x(std::abs(to.x) >= std::abs(to.y)) {
        const double most = std::max(std::abs(to.x), std::abs(to.y));
        aside = static_cast<float>(std::min(std::abs(to.x), std::abs(to.y)) / most);
        cell = static_cast<float>(static_cast<double>(grid.dx) / most);
    }

    int dx, dy;  // diagonally downstream, vertices
    bool along_x;
    float aside = 0;  // share of the stream that takes the diagonal
    float cell = 0;   // m along the stream from vertex to vertex

    int straight_x() const { return along_x ? dx : 0; }
    int straight_y() const { return along_x ? 0 : dy; }

    // Calls begin_row(y), then visit(x, y) for each vertex of the row, all from upstream.
    template <class BeginRow, class Visit>
    void each_row(const Grid& grid, BeginRow&& begin_row, Visit&& visit) const {
        for (int j = 0; j < grid.ny; ++j) {
            const int y = dy > 0 ? j : grid.ny - 1 - j;
            begin_row(y);
            for (int i = 0; i < grid.nx; ++i) visit(dx > 0 ? i : grid.nx - 1 - i, y);
        }
    }
};

}  // namespace sim::weather
