#pragma once

#include <glm/vec3.hpp>

namespace render {

inline constexpr double kLowestSunDeg = -18;  // astronomical night begins; scenes and the window go no lower
inline constexpr double kHighestSunDeg = 90;

// Colours of the light and the sky, as linear-light sRGB. Exposure is part of them, as if a photographer set
// it: white ground stays below clipping at noon, and visible at night.
struct SkyLight {
    bool moon = false;              // the light that casts shadows: the moon, or else the sun
    double lamp_elevation_deg = 0;  // of that light
    glm::dvec3 lamp{0};             // light that reaches a surface facing it; 0 where sun and moon change
    glm::dvec3 above{0}, below{0};  // light from the open sky, and from the ground
    double openness_contrast = 0;   // 0 to 1: of slopes in the sun and of hollows, beyond what they are
    glm::dvec3 toward{0}, away{0};  // horizon below the sun, and opposite
    glm::dvec3 zenith{0};
    double sunward = 0;   // how much more light comes from the sky on the sun's side; < 0: on the moon's
    double haze = 0;      // brightness of haze beside the horizon: a low sun leaves valleys in the shade
    glm::dvec3 glow{0};   // air round the lamp
    glm::dvec3 cloud{0};  // thin cloud
    double stars = 0;     // 0 to 1
};

// Returns the light for a height of the sun, −90 to 90 degrees; it is continuous in it, apart from `moon` and
// `lamp_elevation_deg`, which change while `lamp` and `glow` are 0.
//
//   sun      90° … 1.5°   1.5° … −1°    −1° … −6°           −6° … −15°        below
//   light    sun          sun sets      sky alone (dusk)    moon brightens    moon, stars
//
// Air mass: Kasten and Young (1989). Extinction: optical depths of clear mountain air for red, green and blue.
// The other colours are chosen by eye. The moon is full and stays at one height: a sandbox needs light.
SkyLight sky_light(double sun_elevation_deg);

}  // namespace render
