#pragma once

#include "render/look.h"
#include "render/marks.h"
#include "sim/fields/flow_stage.h"

namespace game {

// How a sandbox is shown; nothing of it reaches the world.
struct Display {
    render::Overlay overlay = render::Overlay::kNone;
    bool contours = false;
    bool flow_mesh = false;         // edges, fronts and points of what carries a texture
    sim::fields::FlowNumbers flow;  // of a scene that shows one
    render::Light light;            // of the scene until the person moves the sun
    float detail = 1;               // 0 to 1, small-scale relief
    double resolution = 1;          // drawn pixels per screen pixel along an edge, 0.25 to 1
    bool fine = false;              // two by two samples per pixel
    double letters = 1;             // size of letters against what the monitor asks for, 0.5 to 3
    bool operator==(const Display&) const = default;
};

}  // namespace game
