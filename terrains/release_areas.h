#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/grid.h"
#include "terrains/georeference.h"

namespace terrains {

// Where a slab of snow may let go, judged by the shape of the ground alone. The limits are those of published rules: slopes of
// Bühler and others (2013, 2018) and of Veitinger and others (2016), curvature of the former, ruggedness of the latter.
struct ReleaseRules {
    double least_slope = 28, most_slope = 55;  // degrees
    double most_ruggedness = 0.01;             // of 3 × 3 cells (Sappington and others 2007): 0 on a plane
    double most_curvature = 6;                 // of a contour line, rad per 100 m, on a rib or in a gully
    double most_forest = 0.3;                  // share of a cell under crowns
    double least_area = 2500;                  // m² in plan
    double most_area = 100'000;                // m² in plan; a fragment that joins may exceed it
    bool operator==(const ReleaseRules&) const = default;
};

struct ReleaseArea {
    double area = 0;                 // m² in plan
    double area_on_slope = 0;        // m² along the slope
    double slope = 0;                // degrees, mean
    double aspect = 0;               // degrees, down the slope, clockwise from north, 0 to 360: mean
    double lowest = 0, highest = 0;  // m, of the surface
    double favour =
        0;  // 0 to 1, mean: how favourable slope and ruggedness are (Veitinger and others 2016, without wind)
    LocalPoint middle;  // mean of its cells
};

struct ReleaseAreas {
    std::vector<int> number;         // per vertex: the number of its area, from 1, or 0
    std::vector<ReleaseArea> areas;  // number 1 first, the largest
};

// Finds areas on a surface of grid.nx × grid.ny heights, m. A cell belongs to one if most of the nine around it keep all rules.
// Areas end where the slope, averaged over some 30 m, turns to another eighth of the compass, so at ribs and gullies too; a
// piece smaller than the least area joins the neighbour with which it shares most of its border and whose slope turns less
// than 70° from its own, or is left out. An area that is too large is cut along its fall line, where it rises most above its own
// plane in its middle half: at a rib; on an even face in the middle; and across its fall line if it is much longer than wide.
// `has_data`: 0 where the ground is not known; `forest`: shares under crowns, 0 to 255, or empty.
ReleaseAreas find_release_areas(const sim::Grid& grid, std::span<const float> surface,
                                std::span<const std::uint8_t> has_data, std::span<const std::uint8_t> forest,
                                const ReleaseRules& rules);

}  // namespace terrains
