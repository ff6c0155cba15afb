#pragma once

#include <cstdint>
#include <vector>

#include "sim/core/grid.h"
#include "sim/world/state.h"

namespace render {

// The block of terrain as indices of triangles, counter-clockwise from outside. An index encodes a vertex of
// the grid: its x and y in 15 bits each, so that a shader decodes them without a division, and a flag for the
// base of the block beneath it.
struct GroundMesh {
    std::vector<std::uint32_t> surface;
    std::vector<std::uint32_t> walls;  // along every edge of the surface: borders and no-data
};

// Depth of the block's base below the lowest bedrock, m.
double block_depth(const sim::Grid& grid);

std::uint32_t surface_index(int x, int y);
std::uint32_t base_index(int x, int y);

// Each square is cut by the diagonal from its lower left to its upper right corner. Triangles that touch a
// no-data vertex (kDrain) are left out. The grid has at most 32,768 vertices along a side.
GroundMesh ground_mesh(const sim::Grid& grid, const sim::Field<sim::Site>& site);

}  // namespace render
