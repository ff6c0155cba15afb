#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/mountain/height_range.h"

namespace render {

// A quantity that colours the ground in place of its material.
enum class Overlay {
    kNone,
    kSlope,        // classes of the surface's steepness, in the colours of avalanche services
    kStanding,     // depth of the standing layer
    kRolling,      // depth of the rolling layer
    kSpeed,        // of the rolling layer, in plan
    kStretch,      // distortion of the textures that a flow advects: greatest over least stretch
    kPressure,     // impact pressure ρ v² of the rolling layer, v along the slope; needs Marks::density
    kProbability,  // of FrameInput::probability; needs Marks::probability
    kWater,        // share of the standing layer that is saturated
};

// A circle around a place, draped on the surface.
struct Ring {
    glm::dvec2 centre{0};  // m
    double radius = 10;    // m, > 0, in plan
    glm::vec3 colour{1};   // linear light, 0 to 1
    bool operator==(const Ring&) const = default;
};

// The outline of what is about to be placed, draped on the surface: a rectangle along a line.
struct Outline {
    glm::dvec2 from{0}, to{0};  // middles of its ends, m
    double width = 1;           // m, > 0, across the line, in plan
    bool front = false;         // a heavier line at `to`
    glm::vec3 colour{1};        // linear light, 0 to 1
    bool operator==(const Outline&) const = default;
};
// That of a building: `length` along its front's direction, degrees clockwise from north.
Outline outline_of(glm::dvec2 middle, double turn, double length, double width, const glm::vec3& colour);

// Annotations on the ground for the viewer, separate from its look.
struct Marks {
    Overlay overlay = Overlay::kNone;
    bool contours = false;   // lines of equal height, contour_interval() apart, every fifth one heavier
    bool flow_mesh = false;  // edges of a flow's cut mesh, its fronts and their points
    std::optional<Ring> ring = std::nullopt;
    std::optional<Outline> outline = std::nullopt;
    // Not 0: a dashed line around FrameInput::extent, of which another one has another number.
    std::int64_t extent = 0;
    // Not 0: there is a FrameInput::probability, of which another one has another number.
    std::int32_t probability = 0;
    glm::vec2 density{0};  // kg/m³, of the upper and the lower material, for kPressure; 0 if unknown
    bool operator==(const Marks&) const = default;

    bool has_lines() const { return contours || ring || outline || extent != 0; }
};

// A value and its colour.
struct LegendStop {
    float value;
    glm::vec3 colour;  // sRGB, 0 to 1
};

// What the colours of an overlay mean. Rendering uses this same table: level sunlit ground has exactly these
// colours, shadow halves them and a slope toward the sun is slightly lighter.
struct Legend {
    // Rising values; at most MOST_STOPS of slots.glsl. Below the first stop the ground's own colour shows. If
    // not stepped, it fades from half of the first value on. Above the last stop its colour continues.
    std::span<const LegendStop> stops;
    const char* unit;  // of the values; a string literal
    // True: a stop's colour holds up to the next stop. False: colours between stops are interpolated linearly
    // in sRGB.
    bool stepped;
};
// Returns no stops for kNone.
Legend legend_of(Overlay overlay);

// Contour interval in metres: 1, 2 or 5 times a power of ten, the smallest with which at most 40 lines cross
// the terrain, and at least 1 m. Contours lie at whole multiples above the terrain's zero.
double contour_interval(HeightRange heights);

}  // namespace render
