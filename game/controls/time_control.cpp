#include "game/controls/time_control.h"

#include <utility>

namespace game {
namespace {

constexpr double kSeenAgainSpeed = 2, kSlowMotion = 0.25;  // ×

}  // namespace

void TimeControl::begin_world() {
    run_on();
    jump();
    takes_over_ = sees_again_ = false;
}

void TimeControl::jump() {
    begin_epoch();
    pace_.forget();
}

void TimeControl::set_pace(double now_s, bool slow_release, bool fast_creep, bool busy) {
    double pace = 1;
    if (slow_release && pace_.is_moment(now_s)) pace = Pace::kAtRelease;
    if (fast_creep && pace_.creeps()) pace = Pace::kInCreep;
    clock_.set_pace(clock_.runs_back() || busy ? 1 : pace);
}

void TimeControl::slow_motion() {
    const bool is_slow = clock_.speed() == kSlowMotion;
    if (!is_slow) speed_before_ = clock_.speed();
    clock_.set_speed(is_slow ? speed_before_ : kSlowMotion);
}

void TimeControl::run_on() {
    clock_.run_back(false);
    target_.reset();
}

void TimeControl::turn_round() {
    stop_seeing_again();
    clock_.run_back(!clock_.runs_back());
    clock_.pause(false);
    target_.reset();
}

void TimeControl::go_to(std::int64_t tick) {
    stop_seeing_again();
    clock_.run_back(false);
    target_ = tick;
}

void TimeControl::take_over_at(std::int64_t tick) {
    go_to(tick);
    takes_over_ = true;
}

bool TimeControl::arrive(std::int64_t tick) {
    target_.reset();
    if (clock_.runs_back() && tick == 0) {
        clock_.run_back(false);
        clock_.pause(true);
    }
    return std::exchange(takes_over_, false);
}

void TimeControl::see_again(std::int64_t tick) {
    go_to(tick);
    clock_.set_speed(kSeenAgainSpeed);
    clock_.pause(false);
    sees_again_ = true;
}

void TimeControl::stop_seeing_again() {
    if (std::exchange(sees_again_, false)) clock_.set_speed(1);
}

}  // namespace game
