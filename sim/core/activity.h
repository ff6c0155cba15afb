#pragma once

#include <cstdint>

namespace sim {

// What a sub-step may change depends on the one before no farther away than this, in vertices: material moves
// by one, and a slope of second order tells of two.
inline constexpr int kReach = 2;

// Where in a tile anything rolled or came to rest, as bits: somewhere, and within kReach of which of its
// edges.
enum Activity : std::uint8_t {
    kQuiet = 0,
    kSomewhere = 1,
    kNearWest = 2,
    kNearEast = 4,
    kNearSouth = 8,
    kNearNorth = 16,
};

}  // namespace sim
