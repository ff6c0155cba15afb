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

// A recording by its name and with the hash of its file.
struct BenchRecording {
    std::string name, file_hash;
    Recording recording;
    std::filesystem::path file = {};
};

struct MeasureOptions {
    int repeats = 3;                    // ≥ 1
    std::optional<std::int64_t> ticks;  // measured at most; none: to the recording's end
    std::int64_t every = 120;           // ticks from a drawn frame to the next, ≥ 1
    sim::StepOptions step;
    Memory memory;  // of one grid's world
};

// What the states of a run are proven by.
enum class Proof {
    kGolden,      // each that was recorded was met, in every repeat
    kUnverified,  // nothing was recorded of this grid or physics, and the repeats agree
    kInvalid,     // they do not
};
std::string_view to_string(Proof proof);

// A recording on one grid in one physics.
struct Measured {
    std::string recording, file_hash, physics;
    int squares = 0;  // along the longer side
    sim::Grid grid;
    double tick_s = 0;
    int repeats = 0;
    std::vector<PerfRow> rows;  // a tick each; times are medians of the repeats, frame_ms their sum
    std::vector<PerfRow> last;  // of the last repeat alone
    Proof proof = Proof::kInvalid;
    std::string why;                // it is invalid
    double session_bytes = 0;       // of the world, its fronts and what works on them
    std::size_t peak_bytes = 0;     // of the whole program
    double slowest_by_fastest = 1;  // of the repeats, by the sum of their ticks
};

// Plays a few ticks to warm up and then the recording, again and again, drawn by `canvas` if there is one.
// `what` stands before the bar. Errors: the physics cannot be had for this recording, or the machine fails.
Outcome<Measured> measure(const BenchRecording& recording, int squares, const BenchPhysics& physics,
                          const MeasureOptions& options, Canvas* canvas, const std::string& what);

double median_of(std::vector<double> values);  // one of them, the lower of two; at least one

// Of each tick the median over repeats of each part, part by part; the rest is the first's. Each repeat has
// the same ticks.
std::vector<PerfRow> medians_of(std::span<const std::vector<PerfRow>> repeats);

// What is told of measured rows.
struct FrameFigures {
    std::array<StageFigures, kPartCount> parts;
    StageFigures tick;       // sum of what needs no picture
    StageFigures frame;      // sum of all, of the ticks that were drawn; of all where none was
    double frame_ms = 0;     // mean tick and mean drawing
    double slow = 0;         // share of frames that took longer than the time they show
    double busy_fronts = 0;  // share of track, advect and gradient in the frame, while at least three
                             // quarters as many vertices roll as at most

    double frames_per_s() const { return frame_ms > 0 ? 1000 / frame_ms : 0; }
    double share(Part part) const {  // of the mean frame
        return frame_ms > 0 ? parts[static_cast<std::size_t>(part)].mean / frame_ms : 0;
    }
};
FrameFigures frame_figures(const Measured& measured);

}  // namespace game
