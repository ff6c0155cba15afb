#pragma once

#include <array>

namespace game::ui {

// From what pressure on a wall of a kind does not stand (docs/things.md).
struct Wall {
    double pressure;   // kPa
    const char* what;  // it is made of
};
inline constexpr std::array kWalls{Wall{1, "glass"}, Wall{5, "wood"}, Wall{10, "brick"},
                                   Wall{30, "concrete"}};

// The strongest wall that does not stand a pressure, kPa; null: all do.
constexpr const Wall* broken_by(double pressure) {
    const Wall* broken = nullptr;
    for (const Wall& wall : kWalls)
        if (pressure >= wall.pressure) broken = &wall;
    return broken;
}

}  // namespace game::ui
