#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "game/recording/format.h"
#include "game/session/session.h"
#include "render/gl/draw_times.h"

namespace game {

// Timed parts of a frame, in order.
enum class Part { kSolve, kHash, kTrack, kAdvect, kGradient, kPeaks, kUpload, kRemesh, kDraw };
inline constexpr std::size_t kPartCount = 9;
inline constexpr std::array<const char*, kPartCount> kPartNames{
    "solve", "hash", "track", "advect", "gradient", "peaks", "upload", "remesh", "draw"};
inline constexpr std::size_t kTickParts = 6;  // the first six, which run without a frame

// Milliseconds of each part; none if it did not run.
struct PartTimes : std::array<std::optional<double>, kPartCount> {
    std::optional<double>& operator()(Part part) { return (*this)[static_cast<std::size_t>(part)]; }
    const std::optional<double>& operator()(Part part) const {
        return (*this)[static_cast<std::size_t>(part)];
    }
    double tick() const;  // the parts of a tick
    double sum() const;   // all parts
    bool drawn() const { return (*this)(Part::kDraw).has_value(); }
    void add(const render::DrawTimes& times);

    std::optional<render::DrawTimes> passes;  // what kUpload, kRemesh and kDraw are the sums of
};

// One tick's line of the performance log.
struct PerfRow {
    std::int64_t tick = 0;
    double time_s = 0;
    int substeps = 0;
    PartTimes ms;
    double begin_ms = 0;  // since the log began
    double frame_ms = 0;  // all of the tick
    std::size_t active_cells = 0;
    std::optional<std::size_t> points, cut_triangles;  // if fronts are tracked
    double standing_m3 = 0, rolling_m3 = 0, out_m3 = 0, error_m3 = 0;
    std::uint64_t state_hash = 0;
};
// Measures of the last tick, without begin, frame and cut triangles.
PerfRow perf_row(const Session& session);
// None if no fronts are tracked. Visits every triangle, so call it after the frame.
std::optional<std::size_t> cut_triangles(const Session& session);

// Environment of a measurement; the first lines of the log.
struct PerfSurroundings {
    std::string what;       // scene or recording
    std::string file_hash;  // of the recording; empty without one
    int threads = 1;
    std::optional<render::DrawnBy> drawn;
};
// Formats program, commit, compiler, processor and `surroundings` as lines that begin with #, and as JSON.
std::string to_text(const PerfSurroundings& surroundings);
Json to_json(const PerfSurroundings& surroundings);

// Milliseconds of a stage over the ticks in which it ran.
struct StageFigures {
    std::string stage;
    std::size_t count = 0;
    double mean = 0, median = 0, p95 = 0, p99 = 0, most = 0, total = 0;
};
StageFigures figures_of(std::string stage, std::vector<double> ms);

// The figures of a stage without its values, in constant memory. Count, mean, most and total are exact;
// ranks are within 1 % between 10 ns and 15 min.
class StageDigest {
  public:
    void add(double ms);
    StageFigures figures(std::string stage) const;

  private:
    static constexpr std::size_t kBuckets = 2550;
    static constexpr double kLeastMs = 1e-5, kRatio = 1.01;  // of a bucket to the one before it

    double rank(double share) const;

    std::array<std::uint64_t, kBuckets> in_bucket_{};
    std::size_t count_ = 0;
    double least_ = 0, most_ = 0, total_ = 0;
};
// Each part, then "frame".
std::vector<StageFigures> figures_of(std::span<const PerfRow> rows);
// Keyed by stage; shares are of `whole_ms`.
Json to_json(std::span<const StageFigures> figures, double whole_ms);

// What the paper reports of its own scenes (Section 5.1).
struct PaperScene {
    const char* name;       // in JSON
    const char* recording;  // of ours
    int squares;
    double frames_per_s, solve_share;
    const char* fronts_share;  // of velocities, textures and least squares; empty if the paper has none
};
inline constexpr const char* kPaperMachine = "Intel i7-3770K, NVIDIA GTX 660";
inline constexpr std::array<PaperScene, 2> kPaperScenes{
    {{"landslide_80x80", "landslide", 80, 25, 0.10, ""},
     {"snow_avalanche_160x160", "snow-avalanche", 160, 7, 0.14, "25-50 %"}}};

// The columns of the log, and a line below them, without line breaks.
std::string perf_columns();
std::string csv_line(std::size_t frame, const PerfRow& row);

// Collects ticks and writes them as CSV and as figures.
class PerfLog {
  public:
    // Whether each tick is kept, for a log or a trace, or only what figures need, in bounded memory.
    enum class Keeps { kRows, kFigures };

    PerfLog(PerfSurroundings surroundings, Keeps keeps)
        : surroundings_(std::move(surroundings)), keeps_(keeps) {}
    void add(const PerfRow& row);

    // Writes the kept rows beside `path` and renames. Errors: the file cannot be written.
    Outcome<void> write_csv(const std::filesystem::path& path) const;
    std::span<const PerfRow> rows() const { return rows_; }
    // Ranks are exact if rows are kept, else within 1 %.
    std::vector<StageFigures> figures() const;
    Json to_json() const;  // figures, shares of the frame, and the paper's figures

  private:
    PerfSurroundings surroundings_;
    Keeps keeps_;
    std::vector<PerfRow> rows_;
    std::size_t ticks_ = 0;
    std::array<StageDigest, kPartCount + 1> digests_;  // of each part, then of the frame
};

}  // namespace game
