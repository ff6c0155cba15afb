#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "sim/core/grid.h"
#include "terrains/georeference.h"

namespace terrains {

// The text of the GeoJSON that write_outlines() writes. Errors: points that have no place on Earth.
tl::expected<std::string, std::string> outlines_of(const sim::Grid& grid, const Georeference& georeference,
                                                   std::span<const std::uint8_t> mask);

}  // namespace terrains
