#include "render/wind.h"

#include <cmath>

#include <glm/ext/scalar_constants.hpp>

namespace render {
namespace {

// Taylor series up to an eighth of a turn, within 1e-9.
double sin_of(double x) {
    const double y = x * x;
    return x * (1 - y / 6 * (1 - y / 20 * (1 - y / 42 * (1 - y / 72))));
}
double cos_of(double x) {
    const double y = x * x;
    return 1 - y / 2 * (1 - y / 12 * (1 - y / 30 * (1 - y / 56 * (1 - y / 90))));
}

}  // namespace

glm::vec2 velocity(const Wind& wind) {
    // The nearest of the four main directions, and the angle from it.
    const double quarters = std::floor(wind.from_deg / 90 + 0.5);
    const double rest = (wind.from_deg - 90 * quarters) * (glm::pi<double>() / 180);
    const double along = -wind.speed * cos_of(rest), aside = -wind.speed * sin_of(rest);
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
