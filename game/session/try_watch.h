#pragma once

#include <cstdint>
#include <optional>

#include "game/scene/goal.h"
#include "sim/world/state.h"

namespace game {

// Finds when a try at a challenge ends: when next to nothing moves any more, but not before its last event; or when
// its time is over. A view: a copy of it is all of its memory.
class TryWatch {
  public:
    static constexpr std::int64_t kStillMoves = 100;  // one part in so many of the greatest volume in motion
    static constexpr double kCalm = 2;                // s for which less moves

    TryWatch(const Goal& goal, float tick_s);

    // Call after every tick.
    void see(const sim::State& state);
    std::optional<std::int64_t> ended_at() const { return ended_at_; }  // tick

  private:
    std::int64_t earliest_ = 0, calm_enough_ = 0;  // ticks
    std::optional<std::int64_t> latest_;
    std::int64_t most_moved_ = 0;  // quanta times cells
    std::int64_t calm_ = 0;        // ticks
    std::optional<std::int64_t> ended_at_;
};

}  // namespace game
