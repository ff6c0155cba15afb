#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace render {

// Ground coloured by what it measures, instead of by what it is made of.
enum class Overlay {
    kNone,
    kSlope,     // classes of the surface's steepness as avalanche services colour them
    kStanding,  // depth of the standing layer
    kRolling,   // depth of the rolling layer
    kSpeed,     // of the rolling layer
};

// A circle around a place, laid onto the surface.
struct Ring {
    glm::dvec2 centre;     // m
    double radius = 10;    // m
    glm::vec3 colour{1};   // linear light
    bool operator==(const Ring&) const = default;
};

// What is drawn onto the ground for a person and is no part of how it looks.
struct Marks {
    Overlay overlay = Overlay::kNone;
    bool contours = false;  // lines of equal height
    std::optional<Ring> ring;
    bool operator==(const Marks&) const = default;
};

}  // namespace render
