#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "game/outcome.h"
#include "game/recording/format.h"
#include "game/session.h"

namespace game {

// One tick's line of the performance log. A stage that did not run in this tick has no value.
struct PerfRow {
    std::int64_t tick = 0;
    double time_s = 0;
    int substeps = 0;
    double solve_ms = 0;
    // Of the fronts, where they are followed.
    struct Fronts {
        double track_ms = 0, gradient_ms = 0, advect_ms = 0;
        std::size_t points = 0, cut_triangles = 0;
    };
    std::optional<Fronts> fronts;
    std::optional<double> draw_ms;  // uploads included
    double frame_ms = 0;            // all of the above
    std::size_t active_cells = 0;
    double standing_m3 = 0, rolling_m3 = 0, out_m3 = 0, error_m3 = 0;
    std::uint64_t state_hash = 0;
};

// What of the surroundings a measurement depends on; the log's first lines.
struct PerfSurroundings {
    std::string what;       // scene or recording
    std::string file_hash;  // of the recording; empty without one
    int threads = 1;
    std::string gl_renderer;  // empty without pictures
};

// Milliseconds of a stage over the ticks in which it ran.
struct StageFigures {
    std::string stage;
    std::size_t count = 0;
    double mean = 0, median = 0, p95 = 0, p99 = 0, most = 0, total = 0;
};

// Collects ticks; tells of them as CSV and as figures.
class PerfLog {
  public:
    explicit PerfLog(PerfSurroundings surroundings) : surroundings_(std::move(surroundings)) {}
    void add(const PerfRow& row) { rows_.push_back(row); }

    // Writes beside `path` and renames. Errors: the machine's.
    Outcome<void> write_csv(const std::filesystem::path& path) const;
    std::vector<StageFigures> figures() const;  // solve, track, gradient, advect, draw, frame
    Json to_json() const;                       // figures, shares of the frame, and the paper's beside them

  private:
    PerfSurroundings surroundings_;
    std::vector<PerfRow> rows_;
};

}  // namespace game
