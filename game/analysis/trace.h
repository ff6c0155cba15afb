#pragma once

#include <span>
#include <string>

#include "game/session/perf_log.h"

namespace game {

// A run as a trace shows it: a process of its own.
struct TracedRun {
    std::string name;
    std::span<const PerfRow> rows;
};

// Frames, what was done in each, and how many vertices and points of fronts there were, in the Trace Event
// format that Perfetto and chrome://tracing open. Runs stand one after the other. Within a frame its parts
// follow each other without the gaps that were between them; those come last.
std::string trace_of(std::span<const TracedRun> runs);

}  // namespace game
