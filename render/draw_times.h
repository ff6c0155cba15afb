#pragma once

#include <string>
#include <string_view>

namespace render {

// Milliseconds that the stages of a frame took.
struct DrawTimes {
    double upload_ms = 0;  // fields of the world, and coordinates of what it carries, sent
    double remesh_ms = 0;  // its mesh cut along the fronts
    double draw_ms = 0;    // all passes
};

// How they are told apart.
enum class Timing {
    kNone,
    kFinish,   // by the wall clock around glFinish: where the processor draws, that is the work itself
    kQueries,  // by stamps that the GPU takes when it has done what came before
};
std::string_view to_string(Timing timing);  // for people: "wall time around glFinish"

// What suits the context that is current.
Timing suitable_timing();

// What a log tells of frames that were timed.
struct DrawnBy {
    std::string renderer, quality;
    Timing timing = Timing::kNone;
};

}  // namespace render
