#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "sim/core/grid.h"
#include "terrains/geojson.h"

namespace terrains {

// Computes the mean thickness over each vertex's cell (dx² around it), m, from 8 × 8 samples. Where areas
// overlap, the thickest counts. Fails if outlines cross the sample lines over 20 million times.
tl::expected<std::vector<float>, std::string> mean_thickness(const sim::Grid& grid,
                                                             const std::vector<Area>& areas);

}  // namespace terrains
