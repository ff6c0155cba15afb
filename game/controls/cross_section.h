#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "game/session/peak_watch.h"
#include "sim/world/state.h"

namespace game {

// A straight line on the ground, in plan, m.
struct SectionLine {
    glm::dvec2 from{0}, to{0};
    double length() const;
    bool operator==(const SectionLine&) const = default;
};

// The world at a place of such a line.
struct SectionPoint {
    bool has_data = false;
    double ground = 0;                 // m, bedrock above the height that is shown as 0
    double standing = 0, rolling = 0;  // m, vertical
    double speed = 0;  // m/s, of the rolling layer, along the slope; 0 if it is thinner than Peaks::kVisible
    double peak_speed = 0;  // m/s, the greatest there so far
};

// A cross-section of the world along a line: ground, layers on it, and speed of the flow. A view, which never affects
// the world. Does not allocate.
class CrossSection {
  public:
    static constexpr std::size_t kPoints = 240;

    // `zero`: the height that is shown as 0, zero_of_heights(). Empty until see().
    void lay(const SectionLine& line, double zero);
    void clear() { *this = {}; }
    // Reads the world along the line, if there is one.
    void see(const sim::View& world, const Peaks& peaks);

    const std::optional<SectionLine>& line() const { return line_; }
    // From one end to the other, at equal distances; empty without a line.
    std::span<const SectionPoint> points() const {
        return {points_.data(), line_ ? points_.size() : std::size_t{0}};
    }
    // m, the greatest depth of both layers together on the line since it was laid.
    double deepest() const { return deepest_; }

  private:
    std::optional<SectionLine> line_;
    double zero_ = 0, deepest_ = 0;  // m
    std::array<SectionPoint, kPoints> points_{};
};

}  // namespace game
