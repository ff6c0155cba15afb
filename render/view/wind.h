#pragma once

#include <cmath>

#include <glm/ext/scalar_constants.hpp>
#include <glm/vec2.hpp>

namespace render {

// The wind over a world. It belongs to a scene, never to the simulation.
struct Wind {
    static constexpr double kFastest = 60;  // m/s that can be asked for

    double from_deg = 0;  // where it comes from: 0 north, 90 east
    double speed = 0;     // m/s, 0 to kFastest; 0: none
    bool operator==(const Wind&) const = default;
};

// Where it blows to: east and north, m/s. Bit-identical on every machine: only + − × ÷. Inline, because recordings
// are verified without a renderer.
inline glm::vec2 velocity(const Wind& wind) {
    // The nearest of the four main directions, and the angle from it. Taylor series up to an eighth of a turn, within
    // 1e-9.
    const double quarters = std::floor(wind.from_deg / 90 + 0.5);
    const double x = (wind.from_deg - 90 * quarters) * (glm::pi<double>() / 180), y = x * x;
    const double sine = x * (1 - y / 6 * (1 - y / 20 * (1 - y / 42 * (1 - y / 72))));
    const double cosine = 1 - y / 2 * (1 - y / 12 * (1 - y / 30 * (1 - y / 56 * (1 - y / 90))));
    const double along = -wind.speed * cosine, aside = -wind.speed * sine;
    switch (static_cast<int>(quarters) & 3) {
        case 0:
            return {aside, along};
        case 1:
            return {along, -aside};
        case 2:
            return {-aside, -along};
        default:
            return {-along, aside};
    }
}

}  // namespace render
