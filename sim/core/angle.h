#pragma once

#include <cmath>

namespace sim {

// The angle of a slope that rises so much over so much, run > 0, as std::atan2 would have it, in degrees. Made of
// arithmetic and square roots alone, whose last bit IEEE 754 defines: that of std::atan2 differs between mathematics
// libraries.
inline double degrees_of_slope(double rise, double run) {
    double tangent = rise / run, halvings = 1;
    for (int i = 0; i < 4; ++i) {
        tangent /= 1 + std::sqrt(1 + tangent * tangent);  // of half the angle
        halvings *= 2;
    }
    // At most tan 5.625°, so that the next term of the series, x^21/21, is below the last bit.
    const double squared = tangent * tangent;
    double series = 0;
    for (int odd = 19; odd > 0; odd -= 2) series = 1.0 / odd - squared * series;
    return halvings * tangent * series * (180 / 3.14159265358979323846);
}

}  // namespace sim
