#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "game/base/volumes.h"
#include "game/controls/tier.h"
#include "render/frame/marks.h"
#include "render/view/look.h"
#include "sim/fields/flow_stage.h"

namespace game {

// Settings of what is seen and heard; they never affect the world.
struct Display {
    static constexpr double kLeastFrameMs = 8, kMostFrameMs = 200;

    render::Overlay overlay = render::Overlay::kNone;
    bool contours = false;
    bool labels = false;               // names of the parts of a slide, north and scale
    bool flow_mesh = false;            // texture mesh with edges, fronts and points
    sim::fields::FlowNumbers flow;     // in flow demos
    render::Light light;               // the scene's until the user moves the sun
    std::optional<render::Date> date;  // the scene's, if it states one, until the user chooses a month
    float detail = 1;                  // 0 to 1, small-scale relief
    bool surroundings = true;          // mountains around the grid; else a block cut from them
    bool trees = true;                 // the scene's trees
    bool ghost = true;                 // the outline of the best run of a challenge
    std::size_t probability = 0;       // which of the runs that are shown
    bool ends = true;                  // where its runs ended
    float powder = 1;                  // 0 to 1, strength of powder and dust
    Tier tier = Tier::kFast;           // what an image may lose while something moves
    double frame_ms = 33;              // target for a frame, 8 to 200, unless the tier is full
    double most_scale = 1;             // of a moving image, one of kScales, unless the tier is full
    double letters = 1;                // text size relative to the monitor's scale, 0.5 to 3
    bool contrast = false;             // of panels: high, for projectors and bright rooms
    std::string language;              // code of that of the window; empty: that of the system
    bool field_words = false;          // those of avalanche dynamics, else plain ones
    bool slow_release = true;          // time passes slower for a moment when a slide breaks loose
    bool fast_creep = true;            // and faster when only creep is left of it
    sound::Volumes volumes;            // of sound
    bool shows_shared = true;          // the folder of a shared slide, in the desktop's file manager
    bool operator==(const Display&) const = default;
};

}  // namespace game
