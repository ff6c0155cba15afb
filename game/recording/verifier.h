#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "game/recording/reader.h"
#include "game/session.h"

namespace game {

// How a recording's states compared with those of its replay.
struct Verdict {
    bool comparable = true;             // same physics version
    std::size_t compared = 0;           // states; recordings have one for each tick since format 1.4
    std::int64_t proven_tick = -1;      // every recorded state up to here was met exactly; −1: none
    std::optional<std::string> parted;  // where and how the two first differ
};

// Compares each recorded state with the replay's as it passes.
class Verifier {
  public:
    explicit Verifier(const Recording& recording);

    // To be called after every tick, and before the first.
    void look_at(const Session& session);

    const Verdict& verdict() const { return verdict_; }

  private:
    std::optional<std::uint64_t> recorded_at(std::int64_t tick) const;

    std::vector<StateLine> states_;
    std::size_t next_ = 0;  // the first line of this tick or a later one
    Verdict verdict_;
};

}  // namespace game
