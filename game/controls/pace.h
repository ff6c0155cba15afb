#pragma once

#include <cstddef>
#include <cstdint>

#include "sim/world/state.h"

namespace game {

// How long an hour of weather, which is the next tick, lasts for a viewer at the usual speed, s: longer in a storm.
double shown_seconds(const sim::State& calm);

// Finds how time should pass for a viewer: slower for a moment when a slide breaks loose and when it first hits a house, and
// faster when only creep is left of it. A view, which never affects the world.
class Pace {
  public:
    static constexpr double kAtRelease = 0.5, kInCreep = 4;  // factors of the speed
    static constexpr double kSlowFor = 1;                    // s of real time
    static constexpr std::int64_t kStillCreeps = 33;  // one part in so many of the greatest volume in motion

    // Call after the ticks of a frame, at real time `now_s`.
    void see(const sim::State& state, double now_s);
    // After the world has restarted, or gone to another time.
    void forget() { *this = {}; }

    // It breaks loose, or hits.
    bool is_moment(double now_s) const { return now_s < slow_until_; }
    bool creeps() const { return creeps_; }

  private:
    std::int64_t moved_ = 0, most_moved_ = 0;  // quanta times cells in motion: as seen last, at most so far
    double slow_until_ = 0;                    // s
    std::ptrdiff_t struck_ = -1;               // houses that were hit at all; −1: not known
    bool has_hit_ = false;                     // since nothing moved
    bool creeps_ = false;
};

}  // namespace game
