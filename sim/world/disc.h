#pragma once

#include <algorithm>

#include "sim/core/grid.h"
#include "sim/world/command.h"

namespace sim {

// Vertices within a disc, and for each its share of the whole. A disc smaller than a cell holds its nearest
// vertex, so that nothing a person does is lost between the vertices.
struct Disc {
    double x, y, radius;  // m
    int x0, x1, y0, y1;   // vertices, inclusive; may lie outside the grid

    // `dx` is the grid's spacing, m.
    Disc(const Command& command, double dx);

    // 1 within a disc; for a cone 1 in the middle and 0 on the rim; 0 outside.
    double weight(int i, int j, double dx, Profile profile) const;

    // Calls visit(x, y, weight) for each vertex of the grid whose weight is above 0.
    template <class Visit>
    void each_vertex(const Grid& grid, Profile profile, Visit&& visit) const {
        for (int j = std::max(y0, 0); j <= std::min(y1, grid.ny - 1); ++j)
            for (int i = std::max(x0, 0); i <= std::min(x1, grid.nx - 1); ++i)
                if (const double w = weight(i, j, grid.dx, profile); w > 0) visit(i, j, w);
    }

    // Sum of all weights, of the vertices outside the grid too: what falls there is no longer the world's.
    // The sum runs over whole rows of a disc that may be far larger than the grid, so it is closed-form in
    // the disc's area where the disc has more than 2²⁰ vertices.
    double total_weight(double dx, Profile profile) const;
};

}  // namespace sim
