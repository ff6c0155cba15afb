#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "game/base/outcome.h"
#include "sim/front/tracker.h"

namespace game {

// How a user wants fronts to be tracked. What is not set follows from the rest.
struct TrackRule {
    std::optional<sim::front::PointSource> source;  // of a point's position on its edge [kFit]
    std::optional<sim::front::Rule::Kind>
        rule;                         // by which an edge is cut [kGradient; kLevel with that source]
    std::optional<double> threshold;  // 1/s, of kGradient [jump / 1.5 cells]
    std::optional<double> jump;       // m/s [0.3 of kRelative]
    std::optional<double> level;      // in the scalar's unit
    bool hold = false;                // only with source kPaper

    static constexpr double kLeast = 1e-9, kMost = 1e9;                // of threshold and jump
    static constexpr double kFarthestLevel = 1e30;                     // from 0
    static constexpr double kShortestStep = 1e-6, kLongestStep = 1e6;  // s, between two flows
};

// "paper", "relative"
std::optional<sim::front::Rule::Kind> track_rule_named(std::string_view name);

// Sets what is not set. Errors: the choices do not go together. `has_scalar`: whether each flow has one. `dash` comes before the
// name of a choice: "--" on a command line.
Outcome<void> complete(TrackRule& rule, bool has_scalar, std::string_view dash);

// The tracker's rule of a complete choice, on a mesh.
sim::front::Rule rule_of(const TrackRule& choice, const sim::front::Mesh& mesh);

// A discontinuity point as it is given to users.
struct FrontPoint {
    std::int32_t i = 0, j = 0;  // vertices, i < j
    float f = 0;                // of the edge, 0 at i … 1 at j
    float x = 0, y = 0;         // m
    float w = 0;                // m/s, from i to j
};
// Errors: it is not finite, because velocities are near the end of a float's range.
Outcome<FrontPoint> front_point(const sim::front::Tracker& tracker, const sim::front::Point& point);

}  // namespace game
