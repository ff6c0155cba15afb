#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "game/pages/table.h"
#include "game/recording/format.h"

namespace game {

// What two runs can be compared by: medians of one recording on one grid in one physics, or of one row of the
// scaling study.
struct BenchEntry {
    struct Stage {
        std::string name;
        double ms;
    };
    std::string key;            // "snow-avalanche 160 bcre-inertial"
    std::string end_hash;       // empty in the scaling study
    std::vector<Stage> stages;  // tick, frame, and parts that are a twentieth of the tick or frame at least
};

// A report written by --summary, made by to_json(BenchReport). Errors: it cannot be read, or is no such
// report: one sentence with file and fact (status 2).
Outcome<Json> read_report(const std::filesystem::path& path);
// Errors: something in it is missing or of another kind; a fact without the file.
tl::expected<std::vector<BenchEntry>, std::string> entries_of(const Json& report);

struct BenchComparison {
    Table table;                          // a row for each stage in both
    std::vector<std::string> remarks;     // what keeps the two from being like for like
    std::optional<std::string> too_slow;  // the worst beyond the tolerance, as a sentence
    std::size_t compared = 0;             // stages
};
// `tolerance`: a stage may take so much longer, as a share, ≥ 0. Of stages that took less than a hundredth of
// a millisecond then, which is noise, nothing is said.
BenchComparison compare_entries(const std::vector<BenchEntry>& now, const std::vector<BenchEntry>& then,
                                double tolerance);

}  // namespace game
