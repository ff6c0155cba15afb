#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "sim/core/grid.h"
#include "sim/world/state.h"

namespace render {

// The block of terrain as indices of triangles, counter-clockwise from outside. An index encodes a vertex of
// the grid: its x and y in 15 bits each, so that a shader decodes them without a division, and a flag for the
// base of the block beneath it.
struct GroundMesh {
    static constexpr int kBlock = 8;  // squares along the edge of a block

    // Triangles that are drawn or left out together.
    struct Block {
        std::uint32_t first = 0, count = 0;  // in `surface`
        glm::ivec2 lowest{0}, highest{0};    // vertices at its corners
    };

    std::vector<std::uint32_t> surface;  // block by block
    std::vector<Block> blocks;           // row by row from the south, without empty ones
    std::vector<std::uint32_t> walls;    // along every edge of the surface: borders and no-data
};

// Depth of the block's base below the lowest bedrock, m.
double block_depth(const sim::Grid& grid);

std::uint32_t surface_index(int x, int y);
std::uint32_t base_index(int x, int y);

// Each square is cut by the diagonal from its lower left to its upper right corner. Triangles that touch a
// no-data vertex (kDrain) are left out. The grid has at most 32,768 vertices along a side.
GroundMesh ground_mesh(const sim::Grid& grid, const sim::Field<sim::Site>& site);

}  // namespace render
