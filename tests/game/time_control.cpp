#include "game/controls/time_control.h"

#include <utility>

#include <gtest/gtest.h>

namespace game::test {
namespace {

TEST(TimeControl, goes_to_a_tick_and_then_runs_on) {
    TimeControl time;
    EXPECT_FALSE(time.target());
    time.turn_round();
    time.go_to(40);
    EXPECT_FALSE(time.clock().runs_back()) << "who asks for a moment wants no other one";
    EXPECT_EQ(time.target(), 40);
    EXPECT_FALSE(time.arrive(40));
    EXPECT_FALSE(time.target());
}

TEST(TimeControl, runs_back_to_the_beginning_and_stops_there) {
    TimeControl time;
    time.clock().pause(true);
    time.turn_round();
    EXPECT_TRUE(time.clock().runs_back());
    EXPECT_FALSE(time.clock().paused());
    time.rewind_to(7);
    EXPECT_FALSE(time.arrive(7));
    EXPECT_TRUE(time.clock().runs_back());
    time.rewind_to(-1);
    EXPECT_FALSE(time.arrive(0));
    EXPECT_FALSE(time.clock().runs_back());
    EXPECT_TRUE(time.clock().paused());
    time.turn_round();
    time.turn_round();
    EXPECT_FALSE(time.clock().runs_back()) << "asked twice";
}

TEST(TimeControl, takes_over_where_it_was_asked_to_and_nowhere_else) {
    TimeControl time;
    time.take_over_at(9);
    EXPECT_TRUE(time.arrive(9));
    time.go_to(12);
    EXPECT_FALSE(time.arrive(12));
    time.take_over_at(9);
    time.begin_world();
    EXPECT_FALSE(time.target());
    EXPECT_FALSE(time.arrive(0));
}

TEST(TimeControl, sees_a_slide_again_at_a_higher_speed_until_it_is_made_to_go_elsewhere) {
    TimeControl time;
    time.clock().pause(true);
    time.clock().set_speed(8);
    const auto see_again = [&] {
        time.see_again(20);
        EXPECT_TRUE(time.sees_again());
        EXPECT_EQ(time.target(), 20);
        EXPECT_EQ(time.clock().speed(), 2);
        EXPECT_FALSE(time.clock().paused());
        time.arrive(20);
        EXPECT_TRUE(time.sees_again());
    };
    see_again();
    time.go_to(90);
    EXPECT_FALSE(time.sees_again());
    EXPECT_EQ(time.clock().speed(), 1);
    see_again();
    time.turn_round();
    EXPECT_FALSE(time.sees_again());
    EXPECT_EQ(time.clock().speed(), 1);
}

TEST(TimeControl, begins_another_epoch_wherever_the_world_is_another_one) {
    TimeControl time;
    auto is_another = [&time, before = time.epoch()]() mutable {
        return std::exchange(before, time.epoch()) < time.epoch();
    };
    time.go_to(5);
    time.arrive(5);
    EXPECT_FALSE(is_another());
    time.jump();
    EXPECT_TRUE(is_another());
    time.begin_epoch();
    EXPECT_TRUE(is_another());
    time.begin_world();
    EXPECT_TRUE(is_another());
}

TEST(TimeControl, goes_back_from_slow_motion_to_the_speed_before) {
    TimeControl time;
    time.clock().set_speed(2);
    time.slow_motion();
    EXPECT_EQ(time.clock().speed(), 0.25);
    time.slow_motion();
    EXPECT_EQ(time.clock().speed(), 2);
}

}  // namespace
}  // namespace game::test
