#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "game/recording/reader.h"
#include "game/session/session.h"

namespace game {

// Result of comparing a recording's states with those of its replay.
struct Verdict {
    enum class Kind {
        kExact,          // at least one state was compared, and every recorded one so far is equal
        kDiffers,        // at least one differs
        kNothingProven,  // no state was recorded so far
        kNotComparable,  // recorded by another version of the physics
    };
    Kind kind() const;

    bool comparable = true;             // same physics version
    std::size_t compared = 0;           // ticks; recordings have a state for each since format 1.4
    std::int64_t proven_tick = -1;      // every recorded state up to here is equal; −1: none
    std::optional<std::string> parted;  // where and how the two first differ
};

std::string_view to_string(Verdict::Kind kind);  // "exact", "differs", "nothing proven", "not comparable"

// Compares each recorded state with the replay's during the replay, even if several lines have the state of
// one tick.
class Verifier {
  public:
    explicit Verifier(const Recording& recording);

    // Call before the first tick and after every tick.
    void look_at(const Session& session);

    const Verdict& verdict() const { return verdict_; }

  private:
    struct Hash {
        std::int64_t tick;
        std::uint64_t value;
    };
    struct Mass {
        std::int64_t tick;
        sim::Ledger ledger;
    };

    std::vector<Hash> hashes_;  // of all lines, sorted by tick
    std::vector<Mass> masses_;
    std::size_t next_hash_ = 0, next_mass_ = 0;  // the first of this tick or a later one
    bool is_newer_;  // of a newer format: states may differ because of what this program does not know of it
    Verdict verdict_;
};

}  // namespace game
