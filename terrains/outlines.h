#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "sim/core/grid.h"
#include "terrains/export.h"

namespace terrains {

// Per vertex the number, from 1, of the patch that it is in: vertices of one sign that are joined by their sides. 0 where the sign
// is below 0.
std::vector<int> patches_of(const sim::Grid& grid, std::span<const int> sign);

// The GeoJSON text for write_outlines(). Fails if a point has no position on Earth.
tl::expected<std::string, std::string> outlines_of(const sim::Grid& grid, const Georeference& georeference,
                                                   std::span<const std::uint8_t> mask);

// The same for write_areas().
tl::expected<std::string, std::string> outlines_of(const sim::Grid& grid, const Georeference& georeference,
                                                   std::span<const int> patch,
                                                   std::span<const Properties> properties);

}  // namespace terrains
