#pragma once

#include <cstddef>
#include <cstdint>

#include "terrains/json_reader.h"

// Limits on the files that are read here. game/base/limits.h has all limits as one table, docs/limits.md
// documents it, and a test compares them.
namespace terrains {

inline constexpr std::size_t kMostGeoJsonBytes = std::size_t{64} << 20;
inline constexpr JsonLimits kGeoJsonLimits{.depth = 12, .values = 4'000'000, .members = 1000};
inline constexpr std::size_t kMostGeoJsonPoints = 1'000'000;

inline constexpr std::uint64_t kMostDemPixels = 400'000'000;
inline constexpr int kMostDemSide = 100'000;                        // pixels
inline constexpr std::uint64_t kMostDepthPixels = 100'000'000;      // of a depth raster
inline constexpr std::uint64_t kMostHeightmapPixels = 100'000'000;  // of an image
inline constexpr int kMostHeightmapChannels = 2;

inline constexpr double kLowestGround = -12'000,
                        kHighestGround = 9'000;  // m: below every trench, above every summit
inline constexpr double kSmallestCell = 1e-3, kLargestCell = 1e5;  // m
inline constexpr int kFewestSquares = 8, kMostSquares = 4096;      // along a grid's longer side

}  // namespace terrains
