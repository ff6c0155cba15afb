#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace render {

enum class TrunkPart : std::uint32_t { kBark, kWood, kRoots };

// A corner of a triangle of a trunk. Along x from its root, −0.5, to where it broke, 0.5, in lengths; beside that in diameters at
// the root.
struct TrunkCorner {
    glm::vec3 at, facing;
    TrunkPart part;
};

inline constexpr int kTrunkLevels = 2;  // the first one is the finer

// Three corners per triangle. Bare, tapered, broken at the top, with stubs of branches, and at the root the plate of roots and
// soil that came out with it.
std::array<std::vector<TrunkCorner>, kTrunkLevels> trunk_mesh();

}  // namespace render
