#pragma once

#include <array>
#include <optional>
#include <string>

#include "game/analysis/headless.h"
#include "game/analysis/measures.h"
#include "game/analysis/score.h"
#include "game/files/file_use.h"
#include "game/recording/divergence.h"
#include "game/scene/scenario.h"
#include "game/scene/scene.h"
#include "game/session/perf_log.h"
#include "game/session/session.h"
#include "game/session/verifier.h"
#include "terrains/release.h"

namespace game {

// The result of doing every tick twice.
struct SelfCheck {
    std::array<std::string, 2> names;  // the two ways
    std::int64_t ticks = 0;
    std::optional<Divergence> parted;
};

// The report of a finished run or replay, as JSON and as text.
struct Summary {
    const Scenario& scenario;
    const Session& session;
    const Measures& measures;
    const PerfLog* perf = nullptr;  // none: no timing
    std::optional<Ended> ended;     // why the run stopped; none: where its recording ends
    std::optional<Verdict> verdict;
    std::optional<SelfCheck> paranoid = std::nullopt;
    std::optional<Score> score = std::nullopt;  // of the scenario's goal
    // Of a run on a real hill: what became of its file of a release, and of its reference; null otherwise.
    const terrains::Release* release = nullptr;
    const terrains::Reference* reference = nullptr;
    std::optional<Scene::Size> size = std::nullopt;  // the class of its avalanche
};

Json to_json(const Summary& summary);
std::string to_text(const Summary& summary);
std::string to_text(const Verdict& verdict);  // a sentence and a line break

// Where a run's or a replay's results go besides standard output.
struct ResultOptions {
    std::optional<std::filesystem::path> perf, summary, trace;
    bool json = false;  // on standard output

    PerfLog::Keeps log_keeps() const {
        return perf || trace ? PerfLog::Keeps::kRows : PerfLog::Keeps::kFigures;
    }
};
void add_outputs(const ResultOptions& options, FileUse& use);
// Call before the work starts. Errors: an output file cannot be written (status 3).
Outcome<void> make_places_for(const ResultOptions& options);
// Writes the files and prints the summary. Needs summary.perf. Errors: status 3.
Outcome<void> tell(const Summary& summary, const ResultOptions& options);

}  // namespace game
