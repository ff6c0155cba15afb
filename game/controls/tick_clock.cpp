#include "game/controls/tick_clock.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace game {
namespace {

constexpr double kLongestFrame = 0.25;  // s
constexpr double kMemory = 0.5;         // s over which wanted and lost ticks are averaged

}  // namespace

void TickClock::set_speed(double speed) {
    speed_ = std::exp2(std::rint(std::log2(std::clamp(speed, kSlowest, kFastest))));
}

int TickClock::ticks_due(double elapsed_s, double tick_s, bool tool_works) {
    due_are_steps_ = (paused_ && !tool_works) || steps_ > 0;
    if (due_are_steps_) return std::exchange(steps_, 0);
    const double wanted = elapsed_s * speed_ * pace_ / tick_s;
    const double granted = std::min(elapsed_s, kLongestFrame) * speed_ * pace_ / tick_s;
    const double fade = std::exp(-elapsed_s / kMemory);
    wanted_ = wanted_ * fade + wanted;
    lost_ = lost_ * fade + wanted - granted;
    owed_ += granted;
    const double due = std::floor(owed_);
    owed_ -= due;
    return static_cast<int>(due);
}

void TickClock::ticks_undone(int count) {
    if (due_are_steps_)
        steps_ += count;  // single steps are never dropped
    else
        lost_ += count;
}

double TickClock::reached_speed() const {
    return speed_ * pace_ * (wanted_ > 0 ? 1 - lost_ / wanted_ : 1);
}

bool TickClock::behind() const {
    return !paused_ && reached_speed() < 0.9 * speed_ * pace_;
}

}  // namespace game
