#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "tests/support/worlds.h"

namespace golden {

// A small moving world whose bits are known. It uses only + − × ÷ √, so that it is the same on every machine.
struct Scene {
    std::string_view name;
    support::Ground ground;
    sim::Params params;  // for either model and all schemes
    // Commands by the tick at which they start.
    std::vector<std::pair<int, sim::Command>> hand;
};

std::vector<Scene> scenes();

inline constexpr int kTicks = 150;

}  // namespace golden
