#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/bench/scaling.h"
#include "game/pages/table.h"

namespace game {

// All results of one run of the benchmark.
struct BenchReport {
    PerfSurroundings around;
    std::vector<Measured> cases;
    std::optional<Scaling> scaling;

    std::optional<std::string> invalid() const;  // the first invalid measurement, as a sentence
};

// For the terminal and the page.
std::vector<Table> tables_of(const BenchReport& report);

// For scripts, and for a later comparison: format "couloir bench".
inline constexpr const char* kBenchFormat = "couloir bench";
inline constexpr int kBenchVersion = 1;
Json to_json(const BenchReport& report);

// One line per tick of every recording, grid and physics: these, the columns of the performance log, and
// hash_ms, peaks_ms. For a scaling study, one line per row instead.
std::string csv_of(const BenchReport& report);

}  // namespace game
