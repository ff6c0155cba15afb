#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec2.hpp>

#include "render/mountain/settlement.h"
#include "render/mountain/surroundings.h"

namespace render {

// A bush or tree that people have planted.
struct PlantedTree {
    enum class As : std::uint8_t { kHedge, kHedgeTree, kFruitTree };
    glm::dvec2 at;  // on the grid, m
    As as;
};

// How people use a world's ground. For the eye alone.
//
//     parcels   cells of a jittered lattice, each a box along the contour there; edges are bent by noise, and some cells are cut
//               into strips; only where the ground may be tilled
//     hedges    on some of the borders between parcels, with gaps and single trees
//     gardens   behind houses, with fruit trees on one side
//     verges    worn ground along roads
//     paths     from the door of each house to the nearest road, and from some houses uphill, in bends where it is steep
struct Cultivation {
    // One value for each texel, row 0 the south: 0, or LAND_FIELD and following, LAND_GARDEN, LAND_VERGE, LAND_PATH.
    std::vector<std::uint8_t> uses;
    std::vector<PlantedTree> planted;
};

// Texels of the grid: the middles of the outermost are the outermost vertices.
struct TexelGrid {
    int columns, rows;
    glm::dvec2 spacing;  // m
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x);
    }
};

// `tilled`: how suitable each texel is, 0 to 1. `to_brook`: m, from its water, one value per texel. Both as many as texels.
Cultivation cultivate(const Surroundings& around, const Settlement& settlement, const TexelGrid& grid,
                      const std::vector<float>& tilled, const std::vector<float>& to_brook);

}  // namespace render
