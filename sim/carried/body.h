#pragma once

#include <cstdint>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace sim::carried {

enum class Kind : std::uint32_t { kBoulder, kTrunk };

// A boulder that a flow of soil has laid bare, or the trunk of a tree that it broke. A plain value.
struct Body {
    glm::vec3 at;        // its middle, m; z above the datum
    glm::vec3 velocity;  // m/s
    // Of a boulder a quaternion from its own axes to those of the world: x, y, z, w. Of a trunk the unit vector from its
    // root to its top.
    glm::vec4 turn;
    float size = 0;  // mean diameter of a boulder, length of a trunk, m
    float sunk = 0;  // share of its thickness below the surface, 0 to 1
    std::uint32_t seed = 0;
    std::int32_t vertex = 0;  // of the grid, where it lay or stood, row by row from the south
    Kind kind = Kind::kBoulder;
    bool operator==(const Body&) const = default;
};

}  // namespace sim::carried
