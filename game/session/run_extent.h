#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "game/session/session.h"

namespace game {

// Which part of the ground the flow of a run had reached by which time. Two bytes per vertex hold all of it, because what
// was reached stays reached.
class RunExtent {
  public:
    static constexpr std::int64_t kStep = 30;  // ticks
    static constexpr float kReached = 0.1f;    // m, of the rolling layer: as for the run-out
    // `from`: the tick from which on steps count.
    RunExtent(const sim::Grid& grid, std::int64_t from) : from_(from), reached_(grid.size(), kNever) {}

    // Call after every tick from 0 on.
    void see(const sim::State& state);

    // Of each vertex, row 0 the south: the first step in which the flow was there, or kNever.
    using Step = std::uint16_t;
    static constexpr Step kNever = std::numeric_limits<Step>::max();
    const std::vector<Step>& reached() const { return reached_; }

    // Fills `inside`, one value per vertex, row 0 the south: 255 where the flow was within so many ticks after `from`, else
    // 0.
    void at(std::int64_t ticks, std::vector<std::uint8_t>& inside) const;

  private:
    std::int64_t from_;
    std::vector<Step> reached_;  // of each vertex: the first step in which the flow was there
};

}  // namespace game
