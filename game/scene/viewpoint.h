#pragma once

#include "game/base/outcome.h"
#include "game/scene/scenario.h"

namespace game {

// From where to look, in words that need no heights: at the surface of a place on the grid.
struct Viewpoint {
    double east = 0, north = 0;  // m from vertex (0, 0), of what is looked at
    double azimuth_deg = 0;      // of the camera as seen from there: 0 north, 90 east
    double elevation_deg = 0;    // above the horizon
    double distance_m = 0;
};

// Its camera, if the surface has this height there, m. `like`: has its field of view.
render::Camera camera_of(const Viewpoint& view, double height, const render::Camera& like);

// Makes it the scenario's camera, with the field of view that this has. Errors (status 2): the place is outside the
// grid.
Outcome<void> look_from(const Viewpoint& view, Scenario& scenario);

}  // namespace game
