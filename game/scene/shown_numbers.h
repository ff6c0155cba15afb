#pragma once

#include <string_view>

#include "render/view/camera.h"
#include "render/view/look.h"
#include "render/view/sky_light.h"
#include "render/view/wind.h"
#include "render/woods/woods.h"
#include "sim/fields/flow_stage.h"

// The numbers of what a scene shows, each once: scenes (TomlTable::numbers), recordings (values::numbers_from and
// numbers_json) and docs/scenes.md take names and ranges from here. Those of the physics are in sim/world/params.h, of
// commands in sim/world/command.h.
namespace game {

template <class Of, class Number>
struct ShownNumber {
    std::string_view in_scene;      // key
    std::string_view in_recording;  // key; empty: it is not recorded
    double least, most;             // in the unit of both
    Number Of::*value;
};

inline constexpr ShownNumber<render::Light, double> kLightNumbers[] = {
    {"azimuth", "azimuth_deg", -360, 360, &render::Light::azimuth_deg},
    {"elevation", "elevation_deg", render::kLowestSunDeg, render::kHighestSunDeg,
     &render::Light::elevation_deg},
};

inline constexpr ShownNumber<render::Camera, double> kCameraNumbers[] = {
    {"azimuth", "azimuth_deg", -360, 360, &render::Camera::azimuth_deg},
    {"elevation", "elevation_deg", -89.9, 89.9, &render::Camera::elevation_deg},
    {"distance", "distance_m", 0.1, 1e6, &render::Camera::distance_m},
    {"field_of_view", "field_of_view_deg", 5, 120, &render::Camera::field_of_view_deg},
};

inline constexpr ShownNumber<render::Wind, double> kWindNumbers[] = {
    {"from", "from_deg", -360, 360, &render::Wind::from_deg},
    {"speed", "speed", 0, render::Wind::kFastest, &render::Wind::speed},
};

inline constexpr ShownNumber<render::Look, float> kLookNumbers[] = {
    {"roughness", "roughness", 0, 1, &render::Look::roughness},
    {"sheen", "", 0, 1, &render::Look::sheen},
    {"cover_visible", "cover_visible_m", 0, 10, &render::Look::cover_visible_m},
    {"rolling_visible", "rolling_visible_m", 0.001, 10, &render::Look::rolling_visible_m},
    {"old_cover", "", 0, 10, &render::Look::old_cover_m},
};

inline constexpr ShownNumber<render::PowderLook, float> kPowderNumbers[] = {
    {"powder", "strength", 0, 1, &render::PowderLook::strength},
    {"powder_speed", "speed", 0.1, 100, &render::PowderLook::speed},
};

inline constexpr ShownNumber<render::FlowLook, double> kFlowLookNumbers[] = {
    {"repeats", "repeats", 0.1, 100, &render::FlowLook::repeats},
};

inline constexpr ShownNumber<render::TreeRules, double> kTreeNumbers[] = {
    {"density", "density", 0, render::TreeRules::kDensest, &render::TreeRules::density},
    {"tree_line", "line_m", -12000, 9000, &render::TreeRules::line_m},
};

inline constexpr ShownNumber<sim::fields::FlowNumbers, double> kFlowNumbers[] = {
    {"speed", "speed", 0, 1, &sim::fields::FlowNumbers::speed},
    {"front_speed", "front_speed", -4, 4, &sim::fields::FlowNumbers::front_speed},
    {"smooth", "smooth", 0, 0.1, &sim::fields::FlowNumbers::smooth},
};

}  // namespace game
