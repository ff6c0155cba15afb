#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace render {

// The timed passes of a frame, in order, and their names. A new pass is added here, and marked in
// frame.cpp; logs and pages follow.
enum class Pass {
    kUpload,   // the world's fields and the coordinates of advected textures
    kRemesh,   // cutting the flow's mesh along its fronts
    kSurface,  // with what depends only on the bedrock, in the first frame of a terrain
    kShadow,
    kChanges,  // finding what differs from the last frame
    kDepth,
    kFlow,
    kTerrain,
    kSurroundings,  // mountains around the grid, or the walls of a block
    kSky,
    kStructures,  // and what flows carry; 0 without
    kTrees,       // 0 without
    kPowder,
    kTone,
    kEdges,
};
inline constexpr std::array kPassNames{"upload",     "remesh", "surface", "shadow",       "changes",
                                       "depth",      "flow",   "terrain", "surroundings", "sky",
                                       "structures", "trees",  "powder",  "tone",         "edges"};
inline constexpr std::size_t kPassCount = kPassNames.size();
inline constexpr std::size_t kFirstDrawingPass = static_cast<std::size_t>(Pass::kSurface);

// Milliseconds that each pass of a frame took; 0 if it did not run.
struct DrawTimes {
    std::array<double, kPassCount> ms{};

    double& operator()(Pass pass) { return ms[static_cast<std::size_t>(pass)]; }
    double operator()(Pass pass) const { return ms[static_cast<std::size_t>(pass)]; }
    // All passes but upload and remesh.
    double draw_ms() const {
        double sum = 0;
        for (std::size_t i = kFirstDrawingPass; i < kPassCount; ++i) sum += ms[i];
        return sum;
    }
    double sum() const { return (*this)(Pass::kUpload) + (*this)(Pass::kRemesh) + draw_ms(); }
};

// How passes are timed.
enum class Timing {
    kNone,
    kFinish,     // by the wall clock around glFinish; with a CPU renderer this is the work itself
    kProcessor,  // by the processor time of all threads of this process around glFinish
    kQueries,    // by GPU timestamps taken when the preceding work is done
};
std::string_view to_string(Timing timing);  // for people: "wall time around glFinish"

// The timing that suits the current context and measures how long a frame takes: kFinish or kQueries.
Timing suitable_timing();
// The timing for comparisons: kProcessor or kQueries. Other programs on the machine hardly change processor
// time, but threads of this process must be idle meanwhile, and a frame by two threads takes half of it.
Timing comparable_timing();

// What a log reports about timed frames.
struct DrawnBy {
    std::string renderer, quality;
    Timing timing = Timing::kNone;
};

}  // namespace render
