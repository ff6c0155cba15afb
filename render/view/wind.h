#pragma once

#include <glm/vec2.hpp>

#include "sim/core/angle.h"

namespace render {

// The wind over a world. It belongs to a scene, never to the simulation.
struct Wind {
    static constexpr double kFastest = 60;  // m/s that can be asked for

    double from_deg = 0;  // where it comes from: 0 north, 90 east
    double speed = 0;     // m/s, 0 to kFastest; 0: none
    bool operator==(const Wind&) const = default;
};

// Where it blows to: east and north, m/s; the same bits on every machine. Inline, because recordings are verified without
// a renderer.
inline glm::vec2 velocity(const Wind& wind) {
    const sim::Direction from = sim::direction_of(wind.from_deg);
    return {-wind.speed * from.x, -wind.speed * from.y};
}

}  // namespace render
