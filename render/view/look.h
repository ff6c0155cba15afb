#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "render/view/flow_pattern.h"
#include "render/view/season.h"

namespace render {

// Colours are linear-light sRGB primaries, 0 to 1.
struct Light {
    double azimuth_deg = 135;   // of the sun: 0 north, 90 east
    double elevation_deg = 40;  // above the horizon, −18 to 90: sky_light.h
    bool operator==(const Light&) const = default;
};

// The look of material that advects a texture.
struct FlowLook {
    FlowPattern pattern = FlowPattern::kSnow;
    double repeats =
        9;  // tiles along the longer side of the terrain, > 0; more, if they were wider than 130 m
    bool everywhere = false;  // texture all ground as flow; else only the rolling layer, in its colour
    bool operator==(const FlowLook&) const = default;
};

// Powder or dust that a fast flow throws up; sim/powder/cloud.h has what the numbers mean.
struct PowderLook {
    float strength = 0;  // 0 to 1; 0: none
    float speed = 7;     // m/s, > 0, from which the flow throws it up
    glm::vec3 colour{0.86f, 0.89f, 0.93f};
    bool operator==(const PowderLook&) const = default;
};

// The look of ground and material. It belongs to a scene and its material, never to the simulation.
struct Look {
    glm::vec3 rock{0.145f, 0.13f, 0.12f};           // steep bare ground
    glm::vec3 meadow{0.205f, 0.185f, 0.085f};       // gentle bare ground
    glm::vec3 standing{0.86f, 0.89f, 0.93f};        // erodible layer
    glm::vec3 rolling{0.42f, 0.58f, 0.84f};         // rolling layer
    glm::vec3 lower_standing{0.30f, 0.22f, 0.14f};  // of the lower material in a world of two
    glm::vec3 lower_rolling{0.36f, 0.25f, 0.14f};
    // Grass on the standing layer where nothing has changed it since tick 0; none: it is drawn bare.
    std::optional<glm::vec3> turf, lower_turf;
    float roughness = 0.5f;           // 0 to 1, strength of the rolling layer's small-scale relief
    float sheen = 0;                  // 0 to 1, how much it mirrors the sky: how wet it is
    float cover_visible_m = 0.05f;    // depth at which the standing layer hides the ground, m, > 0
    float rolling_visible_m = 0.05f;  // depth at which the rolling layer is drawn, m, ≥ 0.001
    float old_cover_m = 0;  // old snow that lies on gentle ground and never moves, m, ≥ 0; for the eye alone
    float detail = 1;  // 0 to 1, strength of all small-scale relief and colour variation; 0: plain colours
    // Plants are as on that day; none: grass is straw, and trees are as in winter.
    std::optional<Date> date;
    PowderLook powder, lower_powder;
    std::optional<FlowLook> flow;  // none: no texture is advected
};

}  // namespace render
