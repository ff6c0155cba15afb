#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "render/textures/tile.h"

// The texture recipes. Each makes the same heights and colours on every machine.
namespace render {

struct ColourStop {
    float height;      // raw, 0 to 1; rising from stop to stop
    glm::vec3 colour;  // sRGB, 0 to 1
};

// The output of a recipe: raw heights from 0 to 1, and either a colour for each texel or a colour for each
// height.
struct Surface {
    Tile heights;
    std::vector<glm::vec3> colours;  // of a structured texture: sRGB, 0 to 1, one per texel
    std::vector<ColourStop> ramp;    // of a stochastic one
};

// Interpolates linearly between stops in sRGB; constant beyond the last.
glm::vec3 colour_at(std::span<const ColourStop> ramp, float height);

// Squares of two colours with worn edges.
Surface make_checkerboard();

// Rounded cobbles of many sizes, warm and cool greys, close together with gravel in the gaps.
Surface make_stones();

// Gradient noise in five octaves, from deep sea over sand to red earth.
Surface make_perlin();

// Deposit of a snow avalanche: stacked blocks, lumps and crumbs, blue in the hollows.
Surface make_snow();

// Deposit of a landslide: clods, small stones and crumbs.
Surface make_soil();

}  // namespace render
