#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "render/mountain/cultivation.h"
#include "render/mountain/settlement.h"
#include "render/mountain/surroundings.h"

namespace render {

// What plants and water find on a world's grid at tick 0: where brooks run, how moist the ground is, how people use
// it and where rubble lies. For the eye alone. Equal ground gives an equal land on one machine.
//
// Water runs down the steepest of eight ways over the ground, whose pits are filled from their rims (Barnes, Lehman and
// Mulla 2014). A brook begins where kBrookArea drains; its bed winds where the ground is level. Moisture is the topographic
// index ln(a/tan β) of Beven and Kirkby (1979).
struct Land {
    static constexpr int kUsual = 1024,
                         kInPages = 512;          // texels along a side, at most, save that of the lattice
    static constexpr double kBrookArea = 60'000;  // m² that drain into the beginning of a brook

    // A texel is four numbers of 0 to 255: nearness of a brook's water, from LAND_FAR outside it, 0, to LAND_NEAR inside;
    // moisture; use, as Cultivation::uses; share of rubble. The first row is the south. The middles of the outermost texels are the outermost
    // vertices of the grid.
    int columns = 0, rows = 0;
    std::vector<std::uint8_t> texels;
    std::vector<PlantedTree> planted = {};
    std::uint64_t fingerprint = 0;  // equal for equal lands, else different but for one chance in 2⁶⁴

    glm::dvec2 size{0};  // of the grid, m

    bool empty() const { return texels.empty(); }
    // How far the water of a brook is from a place of the grid, m: below 0 in it, LAND_FAR at most, and in an empty land.
    double to_brook(glm::dvec2 at) const;
    // The use of a place of the grid; 0 in an empty land.
    std::uint8_t use(glm::dvec2 at) const;
};

// Empty for empty surroundings. Takes up to half a second, so that no frame waits for it: a world makes it once.
Land land_of(const Surroundings& around, const Settlement& settlement = {}, int most_along = Land::kUsual);

}  // namespace render
