#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

namespace render {

// A corner of a triangle of a rock, whose mean diameter is 1 and whose middle is the origin.
struct RockCorner {
    glm::vec3 at, facing;
};

inline constexpr int kRocks = 5;       // shapes
inline constexpr int kRockLevels = 3;  // the first one is the finest

// Three corners per triangle: 320, 80 and 20 triangles.
using RockMesh = std::array<std::vector<RockCorner>, kRockLevels>;

// Angular rocks: balls that are cut by planes and stretched, as fragments of a rock with joints are.
std::array<RockMesh, kRocks> rock_meshes();

}  // namespace render
