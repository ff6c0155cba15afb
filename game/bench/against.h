#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "game/pages/table.h"
#include "game/recording/format.h"

namespace game {

// An entry that two reports can be compared by: the medians of one recording on one grid in one physics, or
// of one row of the scaling study.
struct BenchEntry {
    struct Stage {
        std::string name;
        double ms;
    };
    std::string key;            // "snow-avalanche 160 bcre-inertial"
    std::string end_hash;       // empty in the scaling study
    std::vector<Stage> stages;  // tick, frame, and parts that take at least a twentieth of the tick or frame
};

// Reads a report that --summary wrote, made by to_json(BenchReport). Errors: it cannot be read, or is not
// such a report: one sentence with file and fact (status 2).
Outcome<Json> read_report(const std::filesystem::path& path);
// Errors: a member is missing or of another type; a fact without the file.
tl::expected<std::vector<BenchEntry>, std::string> entries_of(const Json& report);

struct BenchComparison {
    Table table;                          // a row for each stage in both
    std::vector<std::string> remarks;     // why the two are not directly comparable
    std::optional<std::string> too_slow;  // the worst stage beyond the tolerance, as a sentence
    std::size_t compared = 0;             // stages
};
// `tolerance`: how much longer a stage may take, as a share, ≥ 0.
// Stages that took less than 0.01 ms are noise and are skipped.
BenchComparison compare_entries(const std::vector<BenchEntry>& now, const std::vector<BenchEntry>& then,
                                double tolerance);

}  // namespace game
