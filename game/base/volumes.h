#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace game::sound {

// Which volume applies.
enum class Group : std::uint8_t { kFlow, kEvents, kAir, kNotes };
inline constexpr std::size_t kGroups = 4;

// How loud it is: 0 to 1 each.
struct Volumes {
    double all = 0.8;
    std::array<double, kGroups> of{1, 1, 1, 1};  // by Group
    bool muted = false;
    bool operator==(const Volumes&) const = default;
};

}  // namespace game::sound
