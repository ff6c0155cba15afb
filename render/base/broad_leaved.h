#pragma once

#include <cstdint>

#include "render/base/tree_model.h"

namespace render {

// How broad-leaved trees grow. In leaf, a face's `other` is its share of bark, else of snow.

enum class Foliage { kLeaves, kBare };

// A beech: limbs rise from a grey stem, and each ends in a cloud of leaves. `slender`: how far it is one of a closed wood, with a
// long stem below a narrower crown, 0 to 1.
TreeModel grow_beech(std::uint32_t seed, float slender, Foliage foliage);
// A birch: light, pointed, with twigs that hang.
TreeModel grow_birch(std::uint32_t seed);
// Hazel, willow, green alder: stems that rise from one foot, with leaves down to the ground.
TreeModel grow_bush(std::uint32_t seed);
// Some beeches side by side, twice as wide as high.
TreeModel grow_broad_leaved_group(std::uint32_t seed, Foliage foliage);

}  // namespace render
