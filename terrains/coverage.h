#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "sim/core/grid.h"
#include "terrains/geojson.h"

namespace terrains {

// Areas on a grid.
struct Coverage {
    std::vector<float>
        mean;  // thickness over each vertex's cell (dx² around it), m; where areas overlap, the thickest
    double overlap = 0;  // m³ of the thinner ones there
};

// Computes the mean thickness from 8 × 8 samples a cell. Fails if outlines cross the sample lines over 20 million times.
tl::expected<Coverage, std::string> cover(const sim::Grid& grid, const std::vector<Area>& areas);

// The area within an outline less its holes, m²; `on_grid`: of its part on the cells of the grid.
double area_of(const Area& area);
double area_on_grid(const Area& area, const sim::Grid& grid);

}  // namespace terrains
