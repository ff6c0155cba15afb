#pragma once

#include <cstdint>

#include "render/textures/tile.h"

namespace render {

inline constexpr std::uint32_t kSeedsPerScale = 30;  // two scales this far apart have nothing in common

// Lumps of one scale: at most one to each cell of a lattice over the tile, each bounded by planes of its own.
struct Lumps {
    int period = 16;                        // cells along the tile's edge
    float share = 1;                        // of the cells that have one
    float smallest = 0.3f, largest = 0.6f;  // radius, cells
    float height = 0.6f;                    // of the top over the middle of its foot, radii
    float wall = 2;                         // slope of the sides: 1 a worn clod, 3 a block
    float tilt = 0.3f;                      // greatest slope of the top
    float rounding = 0.2f;                  // of the edges, radii
    float buried = 0.3f;                    // of the height
    std::uint32_t seed = 0;                 // and the kSeedsPerScale − 1 after it
};

// Lays lumps onto the heights, which are in tile edges as lengths are. Each stands on what lay under its
// middle before; where several overlap the highest counts.
void strew(Tile& tile, const Lumps& lumps);

}  // namespace render
