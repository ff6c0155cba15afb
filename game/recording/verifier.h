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
    std::size_t compared = 0;           // state lines
    std::int64_t proven_tick = -1;      // every state line up to here was met exactly; −1: none
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
    std::vector<StateLine> states_;
    std::size_t next_ = 0;
    Verdict verdict_;
};

}  // namespace game
