#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace render {

// How conifers grow. Lengths are in heights of the tree, its foot at the origin, z up. The same bits on every machine.

// A triangle of needles, bark or snow. Both of its sides are seen.
struct ConiferFace {
    glm::vec3 a, b, c;
    glm::vec3 normal;  // unit vector, by which it is lit
    float snow;        // share that is white, 0 to 1
    float light;       // share of the light that reaches it through the crown, 0 to 1
};
using Conifer = std::vector<ConiferFace>;

inline constexpr float kConiferRadius = 0.19f;  // of a slim tree's crown
inline constexpr float kCushionRadius = 0.8f;   // of a dwarf pine's
inline constexpr float kGroupRadius = 1;        // of some trees side by side

// A spruce: whorls of branches from which twigs hang. `snowy`: share of its branches that carry snow, 0 to 1. `top`: the
// height at which its stem is broken off; 1: nowhere.
Conifer grow_spruce(std::uint32_t seed, float snowy, float top = 1);
// A larch in winter, without needles.
Conifer grow_larch(std::uint32_t seed);
// Dwarf pine: a low cushion of stems that rise on all sides.
Conifer grow_dwarf_pine(std::uint32_t seed);
// A dozen spruces side by side, twice as wide as high.
Conifer grow_group(std::uint32_t seed);

}  // namespace render
