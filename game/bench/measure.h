#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/bench/canvas.h"
#include "game/bench/variant.h"
#include "game/recording/reader.h"
#include "game/scene/memory.h"
#include "game/session/perf_log.h"
#include "sim/engine.h"

namespace game {

// A recording with its name and the hash of its file.
struct BenchRecording {
    std::string name, file_hash;
    Recording recording;
    std::filesystem::path file = {};
};

struct MeasureOptions {
    int repeats = 3;                    // ≥ 1
    std::optional<std::int64_t> ticks;  // most ticks to measure; none: to the recording's end
    std::int64_t every = 120;           // ticks between drawn frames, ≥ 1
    sim::StepOptions step;
    Memory memory;  // that one grid's world may take
};

// How the states of a run are verified.
enum class Proof {
    kGolden,      // every recorded state was matched, in every repeat
    kUnverified,  // no states recorded for this grid or physics, but the repeats agree
    kInvalid,     // neither
};
std::string_view to_string(Proof proof);

// The measurement of a recording on one grid in one physics.
struct Measured {
    std::string recording, file_hash, physics;
    int squares = 0;  // along the longer side
    sim::Grid grid;
    double tick_s = 0;
    int repeats = 0;
    std::vector<PerfRow> rows;  // one per tick; times are medians of the repeats, frame_ms is their sum
    std::vector<PerfRow> last;  // of the last repeat only
    Proof proof = Proof::kInvalid;
    std::string why;                // why it is invalid
    double session_bytes = 0;       // of the world, its fronts and their working memory
    std::size_t peak_bytes = 0;     // of the whole program
    double slowest_by_fastest = 1;  // slowest over fastest repeat, by total tick time
};

// Plays a few ticks to warm up, then the recording repeatedly, drawn by `canvas` if there is one. `what`
// labels the progress bar. Errors: the recording does not support the physics, or the machine fails.
Outcome<Measured> measure(const BenchRecording& recording, int squares, const BenchPhysics& physics,
                          const MeasureOptions& options, Canvas* canvas, const std::string& what);

double median_of(std::vector<double> values);  // one of them, the lower of two; needs at least one

// The median over repeats of each part of each tick; everything
// else is the first repeat's. All repeats have the same ticks.
std::vector<PerfRow> medians_of(std::span<const std::vector<PerfRow>> repeats);

// Summary figures of measured rows.
struct FrameFigures {
    std::array<StageFigures, kPartCount> parts;
    StageFigures tick;       // sum of the parts that need no drawing
    StageFigures frame;      // sum of all parts over the drawn ticks, or over all ticks if none was drawn
    double frame_ms = 0;     // mean tick plus mean drawing
    double slow = 0;         // share of frames that took longer than the time they show
    double busy_fronts = 0;  // share of track, advect and gradient in the frame, while the moving
                             // vertices are at least three quarters of their maximum

    double frames_per_s() const { return frame_ms > 0 ? 1000 / frame_ms : 0; }
    double share(Part part) const {  // of the mean frame
        return frame_ms > 0 ? parts[static_cast<std::size_t>(part)].mean / frame_ms : 0;
    }
};
FrameFigures frame_figures(const Measured& measured);

}  // namespace game
