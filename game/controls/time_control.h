#pragma once

#include <cstdint>
#include <optional>

#include "game/controls/pace.h"
#include "game/controls/tick_clock.h"

namespace game {

// How the time of the open world passes for a viewer: on, at the clock's speed and at the pace that a slide asks for, back,
// or toward a tick. It never affects what happens in a tick.
class TimeControl {
  public:
    const TickClock& clock() const { return clock_; }
    TickClock& clock() { return clock_; }
    Pace& pace() { return pace_; }
    const Pace& pace() const { return pace_; }

    // The world begins, or begins again: time runs on. Speed and pause are as they were.
    void begin_world();
    // The world is at another moment than the ticks since the last frame have led to.
    void jump();
    // Grows then, and when what is known of the world changes as a whole.
    std::int64_t epoch() const { return epoch_; }
    void begin_epoch() { ++epoch_; }

    // Time passes as the slide asks for, if the user wants to see it slower or faster, at time `now_s`; but at the chosen
    // speed for who rewinds or is `busy`.
    void set_pace(double now_s, bool slow_release, bool fast_creep, bool busy);

    // A quarter of the usual speed, or again the speed that there was.
    void slow_motion();

    // Time runs on, toward no tick.
    void run_on();
    // Back and on again, in turn.
    void turn_round();
    // The tick that the world goes to, faster than time, before it runs on; nothing if there is none.
    const std::optional<std::int64_t>& target() const { return target_; }
    void go_to(std::int64_t tick);
    void take_over_at(std::int64_t tick);                  // the user takes the recording over there
    void rewind_to(std::int64_t tick) { target_ = tick; }  // while time runs back
    // The world is there, at `tick`, or has got as near as it can. True if it is to be taken over.
    bool arrive(std::int64_t tick);

    // The slide that began at this tick is seen once more, faster, until time is made to go elsewhere.
    void see_again(std::int64_t tick);
    bool sees_again() const { return sees_again_; }

  private:
    void stop_seeing_again();

    TickClock clock_;
    Pace pace_;
    std::int64_t epoch_ = 0;
    std::optional<std::int64_t> target_;
    bool takes_over_ = false;  // at the target
    bool sees_again_ = false;
    double speed_before_ = 1;  // slow motion
};

}  // namespace game
