#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "game/scene/scenario.h"
#include "tests/replay/all_kernels.h"

// Random sessions of the sandbox: random user actions on a small world, run by the sweep and the plain kernel
// in lockstep, recorded, and replayed by every kernel and number of threads.

namespace game::test {

// One user action.
struct Act {
    enum Kind {
        kTicks,   // waits `ticks` ticks
        kRest,    // waits until nothing moves, 900 ticks at most, and `ticks` more
        kHand,    // gives `command` as a separate action
        kGo,      // seeks to `where` of the known time, 0 its start, 1 the present
        kUndo,    // undoes the last action
        kRedo,    // redoes what was undone last
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

// Worlds of 17 to 65 vertices a side, in each model, scheme and border; one in eight has two materials.
RandomSession random_session(std::uint64_t seed);

// The world in a line, then one action per line, commands as a recording writes them.
std::string to_text(const RandomSession& session);

struct Tally {
    std::int64_t ticks = 0;  // with compared hash and fields
    std::int64_t files = 0;  // recordings that were written
    Replays replays;         // of these recordings
    void add(const Tally& other);
};

// Plays a session; recordings go into `folder`. Returns the first difference, as a
// sentence. At every tick it compares the session's hash with a hash from scratch,
// every field with the plain kernel's bit by bit, and the ledger. At the end it replays
// each recording by every kernel of this machine and with 1, 2, 3 and 8 threads.
std::optional<std::string> fault_of(const RandomSession& session, const std::filesystem::path& folder,
                                    Tally& tally);

// The shortest failing part that was found of a failing session:
// removes actions and halves waits while `fails` returns true.
RandomSession shrunk(RandomSession session, const std::function<bool(const RandomSession&)>& fails);

}  // namespace game::test
