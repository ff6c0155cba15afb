#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "render/mountain/surroundings.h"
#include "render/woods/woods.h"

namespace render {

// The light of a tree, and where its shadow ends. Changes with the direction of the light only.
struct TreeLight {
    float sunlit;   // share of the light that ground lets through to the tree, 0 to 1
    glm::vec3 tip;  // m, where the shadow of its top meets the ground
};

// The light from `sun` (unit vector, z > 0). Without surroundings nothing hides it.
TreeLight light_of(const Tree& tree, const Surroundings* around, const glm::vec3& sun);
// That of each tree of `woods`.
void light_trees(const Woods& woods, const Surroundings& around, const glm::vec3& sun,
                 std::vector<TreeLight>& into);

// The trees that a world may show, their tiles, and the light of each tree.
struct LitTrees {
    std::span<const Tree> trees;
    std::span<const TreeTile> tiles;
    std::span<const TreeLight> lights;
};

// A tile with other trees than before, and which these were.
struct ChangedTile {
    std::uint32_t tile = 0;                            // in LitTrees::tiles
    std::uint32_t first_before = 0, count_before = 0;  // in LitTrees::trees
};

}  // namespace render
