#pragma once

#include <array>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "assets/shaders/slots.glsl"

namespace render {

// The per-frame uniform block of every shader. Its members match assets/shaders/frame.glsl (std140), which
// says what each holds.
struct FrameBlock {
    glm::mat4 clip_from_world;
    glm::vec4 eye;
    glm::vec4 ray_forward, ray_right, ray_up, ray_middle;
    glm::vec4 sun;
    glm::vec4 ground;
    glm::ivec4 size;
    glm::vec4 sweep;
    glm::vec4 haze;
    glm::vec4 rock, meadow, standing, rolling, lower_standing, lower_rolling, turf, lower_turf, material;
    glm::vec4 beyond;
    glm::vec4 ring, ring_colour;
    glm::vec4 outline, outline_colour;
    glm::vec4 contours;
    glm::vec4 flow, flow_tint;
    glm::ivec4 overlay;
    glm::vec4 season;
    glm::vec4 density;
    std::array<glm::vec4, MOST_STOPS> stops;
    glm::vec4 lamp, above, below, toward, away, zenith, glow, cloud, disc;
};
static_assert(sizeof(FrameBlock) == 64 + (39 + MOST_STOPS) * 16);

}  // namespace render
