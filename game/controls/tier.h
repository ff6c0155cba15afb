#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace game {

// What an image may lose while something moves. An image that stands still is always drawn in full.
enum class Tier { kFast, kBalanced, kFull };

struct TierInfo {
    std::string_view name;
    double least_scale;  // drawn pixels per screen pixel along each axis, at least
    bool fine;           // two by two samples per pixel, also while something moves
    const char* tooltip;
};
inline constexpr std::array<TierInfo, 3> kTiers{
    {{"fast", 0.25, false,
      "While something moves: one sample per pixel, and as much resolution as the frame time allows, a "
      "quarter and 640×360 pixels at least, 1280×720 while the camera stands still."},
     {"balanced", 0.75, false,
      "While something moves: one sample per pixel, and three quarters of the resolution at least."},
     {"full", 1, true,
      "Always full resolution with two by two samples per pixel, however long a frame takes."}}};

constexpr const TierInfo& info_of(Tier tier) {
    return kTiers[static_cast<std::size_t>(tier)];
}

constexpr std::optional<Tier> tier_from(std::string_view name) {
    for (std::size_t i = 0; i < kTiers.size(); ++i)
        if (kTiers[i].name == name) return static_cast<Tier>(i);
    return std::nullopt;
}

// The tier that costs less, if there is one.
constexpr std::optional<Tier> below(Tier tier) {
    if (tier == Tier::kFast) return std::nullopt;
    return static_cast<Tier>(static_cast<int>(tier) - 1);
}

}  // namespace game
