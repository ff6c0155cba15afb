#pragma once

#include <string>
#include <string_view>

namespace render {

// Milliseconds that each stage of a frame took.
struct DrawTimes {
    double upload_ms = 0;  // uploading the world's fields and the coordinates of advected textures
    double remesh_ms = 0;  // cutting the flow's mesh along its fronts
    double draw_ms = 0;    // all passes
};

// How the stages are timed.
enum class Timing {
    kNone,
    kFinish,   // by the wall clock around glFinish; with a CPU renderer this is the work itself
    kQueries,  // by GPU timestamps taken when the preceding work is done
};
std::string_view to_string(Timing timing);  // for people: "wall time around glFinish"

// The timing that suits the current context.
Timing suitable_timing();

// What a log reports about timed frames.
struct DrawnBy {
    std::string renderer, quality;
    Timing timing = Timing::kNone;
};

}  // namespace render
