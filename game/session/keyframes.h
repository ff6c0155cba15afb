#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "game/session/session.h"

namespace game {

// Moments of a session to come back to, a number of ticks apart, within a budget of memory: when that is
// spent every other one is forgotten, and they are kept half as often from there on. The beginning is always
// among them.
class Keyframes {
  public:
    // `bytes` for all of them, each of which takes `bytes_each`; at least two are kept.
    Keyframes(std::size_t bytes, std::size_t bytes_each);

    // To be called before the first tick and after every one; keeps the moment if it is due.
    void pass(const Session& session);
    // The latest one at `tick` or before.
    const Session::Checkpoint& before(std::int64_t tick) const;
    // Those after `tick` never were.
    void forget_after(std::int64_t tick);

    std::size_t count() const { return moments_.size(); }
    std::int64_t spacing() const { return spacing_; }  // ticks

  private:
    std::size_t most_;
    std::int64_t spacing_ = 16;
    std::vector<Session::Checkpoint> moments_;  // in order of their ticks
};

}  // namespace game
