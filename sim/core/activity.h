#pragma once

#include <cstdint>

namespace sim {

// Reach of a sub-step, in vertices: a change depends on earlier values no farther away. Material moves by one
// vertex, and a second-order slope uses two.
inline constexpr int kReach = 2;

// Where in a tile material flowed or came to rest, as bits: somewhere, and within kReach of each edge.
enum Activity : std::uint8_t {
    kQuiet = 0,
    kSomewhere = 1,
    kNearWest = 2,
    kNearEast = 4,
    kNearSouth = 8,
    kNearNorth = 16,
};

}  // namespace sim
