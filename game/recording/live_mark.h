#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "game/recording/format.h"

namespace game {

// Stands in the module of a page that plays (game/live), so that a program knows whether it computes the same physics and
// reads the same recordings.
inline constexpr auto kLiveMarkText = [] {
    constexpr std::string_view kWords = "couloir, live: physics ****, format ****.****";
    std::array<char, kWords.size()> text{};
    std::copy(kWords.begin(), kWords.end(), text.begin());
    auto at = text.begin();
    for (const int number : {kPhysicsVersion, kFormatMajor, kFormatMinor}) {
        at = std::find(at, text.end(), '*');
        for (int power = 1000; power > 0; power /= 10) *at++ = static_cast<char>('0' + number / power % 10);
    }
    return text;
}();
inline constexpr std::string_view kLiveMark(kLiveMarkText.data(), kLiveMarkText.size());

}  // namespace game
