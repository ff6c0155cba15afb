#pragma once

#include <span>
#include <string>

#include "game/session/perf_log.h"

namespace game {

// A run in the trace: one process.
struct TracedRun {
    std::string name;
    std::span<const PerfRow> rows;
};

// Writes frames, their stages, and the number of vertices and front points in the Trace Event format that
// Perfetto and chrome://tracing open. Runs follow one another. Within a frame, stages are packed without the
// gaps between them; the gaps come last.
std::string trace_of(std::span<const TracedRun> runs);

}  // namespace game
