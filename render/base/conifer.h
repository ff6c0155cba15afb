#pragma once

#include <cstdint>

#include "render/base/tree_model.h"

namespace render {

// How conifers grow.

// A spruce: whorls of branches from which twigs hang. `snowy`: share of its branches that carry snow, 0 to 1. `top`: the
// height at which its stem is broken off; 1: nowhere.
TreeModel grow_spruce(std::uint32_t seed, float snowy, float top = 1);
// A larch in winter, without needles.
TreeModel grow_larch(std::uint32_t seed);
// A larch with needles in tufts.
TreeModel grow_green_larch(std::uint32_t seed);
// Dwarf pine: a low cushion of stems that rise on all sides.
TreeModel grow_dwarf_pine(std::uint32_t seed);
// A dozen spruces side by side, twice as wide as high.
TreeModel grow_group(std::uint32_t seed);

}  // namespace render
