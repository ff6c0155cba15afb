#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace game {

// SHA-256 (FIPS 180-4) of these bytes, by which a page names its own scripts to the browser. Written here because no
// library that the program links offers it; nothing secret depends on it.
std::array<std::uint8_t, 32> sha256(std::string_view bytes);

}  // namespace game
