#pragma once

#include <optional>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/height_range.h"

namespace render {

// Ground coloured by what it measures, instead of by what it is made of.
enum class Overlay {
    kNone,
    kSlope,     // classes of the surface's steepness as avalanche services colour them
    kStanding,  // depth of the standing layer
    kRolling,   // depth of the rolling layer
    kSpeed,     // of the rolling layer
    kStretch,   // how much textures that a flow carries are drawn out: greatest over least stretch
};

// A circle around a place, laid onto the surface.
struct Ring {
    glm::dvec2 centre{0};  // m
    double radius = 10;    // m, > 0, in plan
    glm::vec3 colour{1};   // linear light, 0 to 1
    bool operator==(const Ring&) const = default;
};

// What is drawn onto the ground for a person and is no part of how it looks.
struct Marks {
    Overlay overlay = Overlay::kNone;
    bool contours = false;   // lines of equal height, contour_interval() apart, every fifth of them heavier
    bool flow_mesh = false;  // edges of a flow's cut mesh, its fronts and their points
    std::optional<Ring> ring = std::nullopt;
    bool operator==(const Marks&) const = default;
};

// A value and its colour.
struct LegendStop {
    float value;
    glm::vec3 colour;  // sRGB, 0 to 1
};

// What the colours of an overlay mean. The picture is drawn from this very table: level ground in the sun has
// exactly these colours, shadow darkens them to a half and a slope toward the sun is a little lighter.
struct Legend {
    // Rising; at most MOST_STOPS of slots.glsl. Below the first stop the ground shows as it is (where not
    // stepped, it fades from half of that value on); above the last one that one's colour goes on.
    std::span<const LegendStop> stops;
    const char* unit;  // of the values; valid for ever
    // True: a stop's colour holds up to the next stop. False: colours between stops are mixed in proportion,
    // in sRGB.
    bool stepped;
};
// No stops for kNone.
Legend legend_of(Overlay overlay);

// Metres between two contours: 1, 2 or 5 times a power of ten, the least of them with which at most 40 lines
// cross the terrain. 1 m at least. Contours are at whole multiples above the terrain's zero.
double contour_interval(HeightRange heights);

}  // namespace render
