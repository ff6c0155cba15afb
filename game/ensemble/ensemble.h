#pragma once

#include <cstdint>
#include <filesystem>
#include <map>

#include "game/base/outcome.h"
#include "game/ensemble/journal.h"
#include "game/ensemble/member.h"
#include "game/ensemble/ranks.h"
#include "game/ensemble/spec.h"
#include "game/ensemble/vertex_counts.h"

namespace game {

inline constexpr const char* kJournalName = "journal.jsonl";
inline constexpr const char* kCountsName = "counts.bin";

// All members of an ensemble, or those that finished before Ctrl+C.
struct EnsembleResult {
    std::map<std::int64_t, Member> members;
    VertexCounts counts;
    std::int64_t before = 0;  // of them: found in the folder, from earlier calls
    std::size_t dropped = 0;  // bytes of a line of the journal that an earlier call had cut off
    double seconds = 0;       // of this call
    bool interrupted = false;
};

// What the folder has by now, for a view: it writes nothing, and may be read while the members are played. `spec` outlives it.
// Errors: there are no results; those of read_journal(); damaged counts (status 2).
Outcome<EnsembleResult> read_ensemble(const EnsembleSpec& spec, const std::filesystem::path& folder);

// Plays the members that the folder lacks, each on one of `threads` threads or, if this is rank 0 of several processes, on
// another of these, with progress. What they come to does not depend on their order, on threads, on processes, or on how often
// the work was ended and begun again: the journal has each finished member at once, the counts follow every ten seconds, and
// members that they lack then are played again.
// Errors: those of Journal and play_member(); the counts are damaged or of another ensemble (status 2).
Outcome<EnsembleResult> run_ensemble(const EnsembleSpec& spec, const std::filesystem::path& folder,
                                     int threads, Ranks* ranks = nullptr);

}  // namespace game
