#pragma once

#include <string>

namespace support {

// The text of a scene of a small slope of soil, without a camera; tests append tables of their own.
inline std::string slope_scene(const std::string& title, int squares) {
    return "title = \"" + title +
           "\"\n[terrain]\ngenerator = \"slope-of-soil\"\ngrid = " + std::to_string(squares) +
           "\n[cover]\nmaterial = \"soil\"\n[physics]\nmodel = \"bcre-inertial\"\nborders = \"open\"\n";
}

}  // namespace support
