#pragma once

#include "render/look.h"
#include "render/marks.h"
#include "sim/fields/flow_stage.h"

namespace game {

// Display settings; they never affect the world.
struct Display {
    render::Overlay overlay = render::Overlay::kNone;
    bool contours = false;
    bool flow_mesh = false;         // texture mesh with edges, fronts and points
    sim::fields::FlowNumbers flow;  // in flow demos
    render::Light light;            // the scene's until the user moves the sun
    float detail = 1;               // 0 to 1, small-scale relief
    bool surroundings = true;       // mountains around the grid; else a block cut from them
    bool trees = true;              // the scene's trees
    float powder = 1;               // 0 to 1, strength of powder and dust
    double resolution = 1;          // drawn pixels per screen pixel along each axis, 0.25 to 1
    bool fine = false;              // two by two samples per pixel
    double letters = 1;             // text size relative to the monitor's scale, 0.5 to 3
    bool operator==(const Display&) const = default;
};

}  // namespace game
