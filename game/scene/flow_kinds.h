#pragma once

#include <array>
#include <string_view>

namespace game {

// Names of the flows that a scene may show, as files spell them; sim/fields/test_flows.h describes them.
inline constexpr std::array<std::string_view, 7> kFlowKinds{"opposed", "swinging", "pinwheel", "disc",
                                                            "drops",   "crowd",    "rift"};
inline constexpr int kMostFlowSquares = 512;  // along a side

}  // namespace game
