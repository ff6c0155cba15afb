#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace render {

// Patterns that a flow can advect. assets/textures holds a texture for each name and says how it was made.
enum class FlowPattern { kCheckerboard, kStones, kPerlin, kSnow, kSoil };

inline constexpr std::array<std::string_view, 5> kFlowPatterns{"checkerboard", "stones", "perlin", "snow",
                                                               "soil"};
static_assert(kFlowPatterns[static_cast<std::size_t>(FlowPattern::kSoil)] == "soil");

constexpr std::string_view to_string(FlowPattern pattern) {
    return kFlowPatterns[static_cast<std::size_t>(pattern)];
}
// Whether copies of the pattern are blended by height before they are coloured (assets/textures/README.md).
constexpr bool is_stochastic(FlowPattern pattern) {
    return pattern == FlowPattern::kPerlin || pattern == FlowPattern::kSnow || pattern == FlowPattern::kSoil;
}
constexpr std::optional<FlowPattern> flow_pattern_named(std::string_view name) {
    for (std::size_t i = 0; i < kFlowPatterns.size(); ++i)
        if (kFlowPatterns[i] == name) return static_cast<FlowPattern>(i);
    return std::nullopt;
}

}  // namespace render
