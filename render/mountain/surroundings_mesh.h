#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/mountain/surroundings.h"
#include "render/view/on_screen.h"

namespace render {

struct SurroundingsVertex {
    glm::vec3 at;       // m, as in shaders
    glm::vec2 slope;    // along x and y
    glm::vec2 source;   // cells, place on the grid whose material is drawn here
    glm::vec2 cover;    // added to that of the source: depth, m, and share of the lower material
    float open;         // share of the sky that is seen, 0 to 1
    float on_grid = 0;  // 1: a vertex of the grid's ground, whose height now is that of the world
};

// A part of the mesh that is drawn or left out as a whole.
struct SurroundingsPatch {
    std::uint32_t first = 0, count = 0;  // indices
    glm::vec3 lowest{0}, highest{0};     // corners of the box around it, m
};

// Triangles, counter-clockwise from above: rings around the grid, and the grid's holes. The innermost ring
// consists of the vertices on the grid's border, so that there is no gap.
struct SurroundingsMesh {
    std::vector<SurroundingsVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<SurroundingsPatch> patches;
};

SurroundingsMesh surroundings_mesh(const Surroundings& around);

// Share of the light from `sun` (unit vector, z > 0) that ground and grid let through to each vertex, 0 to 1.
void sunlit(const Surroundings& around, const std::vector<SurroundingsVertex>& vertices, glm::dvec3 sun,
            std::vector<float>& into);

// The patches that a camera may see, nearest first. Space as in shaders.
void visible_patches(const std::vector<SurroundingsPatch>& patches, const OnScreen& screen, glm::vec3 eye,
                     std::vector<const SurroundingsPatch*>& into);

}  // namespace render
