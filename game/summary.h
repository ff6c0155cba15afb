#pragma once

#include <optional>
#include <string>

#include "game/measures.h"
#include "game/perf_log.h"
#include "game/session.h"
#include "game/start.h"

namespace game {

// How a recording's states compared with those of its replay.
struct Verdict {
    bool comparable = true;             // same physics version
    std::size_t compared = 0;           // state lines
    std::int64_t proven_tick = -1;      // every state line up to here was met exactly; −1: none
    std::optional<std::string> parted;  // where and how the two first differ
};

// What is told of a finished run or replay, as JSON and as text for people.
struct Summary {
    const Start& start;
    const Session& session;
    const Measures& measures;
    const PerfLog* perf = nullptr;  // none: no timing
    std::optional<bool> at_rest;    // asked for and reached, or not
    std::optional<Verdict> verdict;
};

Json to_json(const Summary& summary);
std::string to_text(const Summary& summary);

}  // namespace game
