#pragma once

#include <cmath>
#include <cstdint>

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

// The unit vector toward `degrees` clockwise from north, its sine and cosine; the same bits on every machine.
struct Direction {
    double x, y;
};
inline Direction direction_of(double degrees) {
    // By Taylor series within an eighth of a turn: the C library's functions differ from machine to machine.
    constexpr double kPi = 3.14159265358979323846;
    const double quarters = std::rint(degrees / 90);
    const double angle = (degrees - 90 * quarters) * (kPi / 180), squared = angle * angle;
    double sine = 0, cosine = 0;
    for (int k = 10; k >= 0; --k) {
        sine = 1 - squared / ((2 * k + 2) * (2 * k + 3)) * sine;
        cosine = 1 - squared / ((2 * k + 1) * (2 * k + 2)) * cosine;
    }
    sine *= angle;
    switch (((static_cast<std::int64_t>(quarters) % 4) + 4) % 4) {
        case 0:
            return {sine, cosine};
        case 1:
            return {cosine, -sine};
        case 2:
            return {-sine, -cosine};
        default:
            return {-cosine, sine};
    }
}

}  // namespace sim
