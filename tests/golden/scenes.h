#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "tests/support/worlds.h"

namespace golden {

// A small world that moves, whose bits are known. Made with + − × ÷ √ alone, so that it is the same one on
// every machine.
struct Scene {
    std::string_view name;
    support::Ground ground;
    sim::Params params;  // for either model and all schemes
    // What a person does, by the tick at which it begins.
    std::vector<std::pair<int, sim::Command>> hand;
};

std::vector<Scene> scenes();

inline constexpr int kTicks = 150;

}  // namespace golden
