#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/bench/scaling.h"
#include "game/pages/table.h"

namespace game {

// All that one run of the benchmark found.
struct BenchReport {
    PerfSurroundings around;
    std::vector<Measured> cases;
    std::optional<Scaling> scaling;

    std::optional<std::string> invalid() const;  // the first that is, as a sentence
};

// For the screen and the page.
std::vector<Table> tables_of(const BenchReport& report);

// For scripts, and for a later run to compare with: format "couloir bench".
inline constexpr const char* kBenchFormat = "couloir bench";
inline constexpr int kBenchVersion = 1;
Json to_json(const BenchReport& report);

// A line per tick of every recording, grid and physics: these, the columns of the performance log, and
// hash_ms, peaks_ms; where a scaling study was made a line for each of its rows instead.
std::string csv_of(const BenchReport& report);

}  // namespace game
