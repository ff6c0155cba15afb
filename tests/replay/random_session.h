#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "game/scene/scenario.h"

// Random sessions of the sandbox: what a person could do to a small world, played by the sweep beside the
// plain kernel, recorded, and replayed by every kernel and number of threads.

namespace game::test {

// One thing a person does.
struct Act {
    enum Kind {
        kTicks,   // lets `ticks` pass
        kRest,    // waits until nothing moves, 900 ticks at most, and `ticks` more
        kHand,    // gives `command` as an action of its own
        kGo,      // goes to `where` of the known time, 0 its beginning, 1 the present
        kUndo,    // takes the last action back
        kBranch,  // continues from this tick in a new recording
    };
    Kind kind = kTicks;
    int ticks = 0;
    double where = 1;
    sim::Command command;
};

struct RandomSession {
    std::uint64_t seed = 0;
    Scenario scenario;
    int threads = 1;  // of the sweep
    std::vector<Act> acts;
};

// Worlds of 17 to 65 vertices a side, each model, scheme and border, one in eight of two materials.
RandomSession random_session(std::uint64_t seed);

// The world in a line, then the acts, one per line, hands as a recording writes them.
std::string to_text(const RandomSession& session);

struct Tally {
    std::int64_t ticks = 0;     // at which hash and fields were compared
    std::int64_t files = 0;     // recordings that were written
    std::int64_t replays = 0;   // of these
    std::int64_t replayed = 0;  // states that these compared
    void add(const Tally& other);
};

// Plays it; recordings go into `folder`. Returns the first difference, as a sentence. At every tick: the hash
// of the session against the hash from scratch, every field against the plain kernel's bit by bit, and the
// ledger. At the end: each recording, replayed by every kernel of this machine and by 1, 2, 3 and 8 threads.
std::optional<std::string> fault_of(const RandomSession& session, const std::filesystem::path& folder,
                                    Tally& tally);

// The shortest part of a failing session that was found to fail too: leaves acts out and halves waits for as
// long as `fails` says yes.
RandomSession shrunk(RandomSession session, const std::function<bool(const RandomSession&)>& fails);

}  // namespace game::test
