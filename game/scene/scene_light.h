#pragma once

#include <optional>

#include "game/files/toml_table.h"
#include "game/scene/scenario.h"

namespace game {

// The [light] of a scene file: the direction to the sun, or a moment at which the sun's position is computed.

// A moment, and the place from which the sun is seen. No place: that of the scene's terrain.
struct SunMoment {
    double unix_s = 0;  // UTC, from 1970-01-01
    std::optional<terrains::LatLon> place;
};

// Reads [light] into `light`, if it gives a direction. Returns the moment, if it gives one.
std::optional<SunMoment> read_light(TomlTable& table, render::Light& light);

// Sets the scenario's light to the sun at that moment, once the scenario has its ground. The azimuth is
// counted from the grid's y axis, which is not quite north on a projected map. A sun below the lowest
// elevation of a scene is set to that: it is the same night. Returns false, and sets nothing, if the place is
// known neither from [light] nor from the ground.
bool set_sun(const SunMoment& moment, Scenario& scenario);

}  // namespace game
