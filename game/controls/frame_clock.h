#pragma once

#include <optional>

#include "game/controls/frame_times.h"

namespace game {

// The time on a screen's clock, frame by frame, and the times of the last frames.
class FrameClock {
  public:
    // A frame begins at `now_s`. Returns the seconds since the last one began, without those that were skipped.
    double begin(double now_s) {
        const double elapsed_s = now_s - now_s_;
        now_s_ = now_s;
        if (last_) {  // only now is known how long it took
            last_->frame_ms = static_cast<float>(1000 * elapsed_s);
            times_.add(*last_);
        }
        return elapsed_s;
    }
    void end(const FrameTime& frame) { last_ = frame; }
    // The time until `now_s` is not to be simulated, because something had to be waited for.
    void skip_to(double now_s) { now_s_ = now_s; }

    double now_s() const { return now_s_; }
    const FrameTimes& times() const { return times_; }

  private:
    double now_s_ = 0;
    FrameTimes times_;
    std::optional<FrameTime> last_;  // not in times_ yet
};

}  // namespace game
