#pragma once

#include <cstdint>

namespace game {

// Sobol's sequence: points that fill a cube evenly, whatever number of them is taken. Directions of Joe and Kuo (2008,
// new-joe-kuo-6), shifted by digits that follow from `seed`.
inline constexpr int kMostSobolDimensions = 16;

// Coordinate `dimension` (from 0) of point `index`, above 0 and below 1. Follows from the arguments alone.
double sobol(std::uint64_t seed, int dimension, std::uint32_t index);

}  // namespace game
