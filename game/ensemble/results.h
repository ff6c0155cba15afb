#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "game/ensemble/ensemble.h"
#include "game/ensemble/variance.h"
#include "game/pages/table.h"
#include "game/recording/json_values.h"

namespace game {

// Names of the files that write_results() writes, with * for any characters.
inline const std::vector<std::string> kEnsembleNames{"members.csv",   "ensemble.json", "report.html",
                                                     "probability_*", "areas_*",       "hardest_*",
                                                     "percentile_*",  kJournalName,    kCountsName};

// Writes what the members came to: members.csv; each map as GeoTIFF, in the coordinate system of the ground, and as a
// picture; all of it as a page, report.html; ensemble.json. The bytes do not depend on how the members were played.
// Errors: a file cannot be written (status 3).
Outcome<void> write_results(const std::filesystem::path& folder, const EnsembleSpec& spec,
                            const EnsembleResult& result);

// How many members could not run, and how many still moved at the end.
std::int64_t faults_in(const EnsembleResult& result);
std::int64_t unfinished_in(const EnsembleResult& result);

// What is told of the spread of the members.
struct Told {
    const char *name, *unit, *words;  // "run_out", "m", "run-out"
    double Member::*value;
};
std::span<const Told> told_of_members();
// A number of the members that ran.
std::vector<double> values_of(const EnsembleResult& result, double Member::*value);

// How such numbers are spread, from the least to the greatest.
struct Spread {
    double least = 0, tenth = 0, middle = 0, nine_tenths = 0, most = 0;
};
Spread spread_of(std::vector<double> values);
Table spread_table(const EnsembleResult& result);

// How much of the variance of a number of the members each variable explains (game/ensemble/variance.h), and the same of all
// numbers that are told, in %; the table has no row if nothing can be said.
std::optional<VarianceShares> variance_of(const EnsembleResult& result, double Member::*value);
Table variance_table(const EnsembleSpec& spec, const EnsembleResult& result);

Json to_json(const EnsembleSpec& spec, const EnsembleResult& result);

}  // namespace game
