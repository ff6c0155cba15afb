#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/bench/fit.h"
#include "game/bench/measure.h"

namespace game {

// How the cost of every part grows: one avalanche on grid after grid, looked at while it is under way.
struct ScalingRow {
    int squares = 0;  // along the longer side
    std::size_t vertices = 0;
    double time_s = 0;  // since the beginning
    int substeps = 0;
    std::size_t moving = 0;    // vertices that roll
    std::size_t points = 0;    // of the fronts
    PartTimes ms;              // medians of a few ticks
    double session_bytes = 0;  // as in Measured; of the grid
};

struct Scaling {
    std::string recording, file_hash, physics;
    int ticks_each = 0;  // of which each row is the median
    std::vector<ScalingRow> rows;
    Proof proof = Proof::kUnverified;  // golden if the recording's own grid was among them
    std::string why;
};

inline constexpr std::array kScalingSquares{40, 80, 160, 320, 640, 1280, 2048};
inline constexpr std::array kScalingSeconds{5, 15, 25};

// Fronts are followed on every grid; drawn only where any GL could (kMostFollowed), and not at all
// without `canvas`. how.repeats and how.every count for nothing. Errors as in measure().
Outcome<Scaling> measure_scaling(const BenchRecording& recording, std::span<const int> squares,
                                 const BenchPhysics& physics, const MeasureOptions& options, Canvas* canvas);

// How a part grows with the vertices alone, with the points of the front alone, and with both: cost ≈
// vertices^a · points^b.
struct Exponents {
    std::string part;  // as in kPartNames, or "tick"
    std::optional<PowerLaw> by_vertices, by_points, by_both;
};
std::vector<Exponents> exponents_of(std::span<const ScalingRow> rows);

}  // namespace game
