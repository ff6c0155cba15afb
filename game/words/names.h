#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "game/words/words.h"

// Names that tr() is given later.

namespace game {

// Of a direction, degrees from north to the east.
inline const char* compass_point(double degrees) {
    constexpr std::array kPoints{message("N"), message("NE"), message("E"), message("SE"),
                                 message("S"), message("SW"), message("W"), message("NW")};
    const double turned = degrees - 360 * std::floor(degrees / 360);
    return kPoints[static_cast<std::size_t>(std::lround(turned / 45)) % kPoints.size()];
}

// Of a month, 1 to 12; short.
inline const char* month_name(int month) {
    constexpr std::array kMonths{message("Jan"), message("Feb"), message("Mar"), message("Apr"),
                                 message("May"), message("Jun"), message("Jul"), message("Aug"),
                                 message("Sep"), message("Oct"), message("Nov"), message("Dec")};
    return kMonths.at(static_cast<std::size_t>(month - 1));
}

}  // namespace game
