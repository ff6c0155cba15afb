#pragma once

#include <cstdint>

#include "render/textures/tile.h"

namespace render {

inline constexpr std::uint32_t kSeedsPerScale = 30;  // seeds this far apart give independent scales

// Lumps of one scale: at most one to each cell of a lattice over the tile, each bounded by planes of its own.
struct Lumps {
    int period = 16;                        // cells along the tile's edge
    float share = 1;                        // of the cells that contain a lump
    float smallest = 0.3f, largest = 0.6f;  // radius, cells
    float height = 0.6f;                    // of the top over the middle of its foot, radii
    float wall = 2;                         // slope of the sides: 1 a worn clod, 3 a block
    float tilt = 0.3f;                      // greatest slope of the top
    float rounding = 0.2f;                  // of the edges, radii
    float buried = 0.3f;                    // share of the height
    std::uint32_t seed = 0;                 // first of kSeedsPerScale seeds
};

// Adds lumps to the heights, which are in tile edges as lengths are. Each stands on the height under its
// middle before the call. Where lumps overlap the highest counts.
void strew(Tile& tile, const Lumps& lumps);

}  // namespace render
