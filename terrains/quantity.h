#pragma once

namespace terrains {

// What the numbers of a raster mean, which decides their unit, their range and their words.
enum class Quantity {
    kHeight,  // of the ground, m, −12,000 to 9,000
    kDepth,   // of a layer or of a change, m, −200 to 200
    kShare,   // of a wood, 0 to 1; a resampling may exceed that by a tenth
};

}  // namespace terrains
