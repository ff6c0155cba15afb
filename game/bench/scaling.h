#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/bench/fit.h"
#include "game/bench/measure.h"

namespace game {

// How the cost of every part scales: one avalanche on a series of grids, measured at several moments.
struct ScalingRow {
    int squares = 0;  // along the longer side
    std::size_t vertices = 0;
    double time_s = 0;  // since the start
    int substeps = 0;
    std::size_t moving = 0;    // vertices with a rolling layer
    std::size_t points = 0;    // of the fronts
    PartTimes ms;              // medians of a few ticks
    double session_bytes = 0;  // of the grid, as in Measured
};

struct Scaling {
    std::string recording, file_hash, physics;
    int ticks_each = 0;  // ticks per row, of which the row is the median
    std::vector<ScalingRow> rows;
    Proof proof = Proof::kUnverified;  // golden if the recording's own grid is included
    std::string why;
};

inline constexpr std::array kScalingSquares{40, 80, 160, 320, 640, 1280, 2048};
inline constexpr std::array kScalingSeconds{5, 15, 25};

// Fronts are tracked on every grid, but drawn only where every GL can (kMostFollowed), and never without
// `canvas`. Ignores how.repeats and how.every. Errors: as in measure().
Outcome<Scaling> measure_scaling(const BenchRecording& recording, std::span<const int> squares,
                                 const BenchPhysics& physics, const MeasureOptions& options, Canvas* canvas);

// How a part scales with the vertices alone, with the front
// points alone, and with both: cost ≈ vertices^a · points^b.
struct Exponents {
    std::string part;  // as in kPartNames, or "tick"
    std::optional<PowerLaw> by_vertices, by_points, by_both;
};
std::vector<Exponents> exponents_of(std::span<const ScalingRow> rows);

}  // namespace game
