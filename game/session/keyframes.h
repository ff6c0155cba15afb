#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "game/session/session.h"

namespace game {

// Memory that a checkpoint holds, bytes. It grows with what stands, with the powder, and with the front.
std::size_t bytes_of(const Session::Checkpoint& moment);

// Checkpoints of a session at equal distances in ticks, within a memory budget. Over budget, drops every
// other keyframe and doubles the distance. Always keeps tick 0.
class Keyframes {
  public:
    // `bytes`: the budget. Keeps at least two.
    explicit Keyframes(std::size_t bytes) : most_(bytes) {}

    // Call before the first tick and after every tick. Keeps a checkpoint if one is due.
    void pass(const Session& session);
    // Returns the latest one at `tick` or before.
    const Session::Checkpoint& before(std::int64_t tick) const;
    // Drops keyframes after `tick`.
    void forget_after(std::int64_t tick);

    std::size_t count() const { return moments_.size(); }
    std::int64_t spacing() const { return spacing_; }  // ticks

    std::size_t bytes() const { return bytes_; }  // that they hold together

  private:
    void thin_out();

    std::size_t most_, bytes_ = 0;
    std::int64_t spacing_ = 16;
    std::vector<Session::Checkpoint> moments_;  // sorted by tick
};

}  // namespace game
