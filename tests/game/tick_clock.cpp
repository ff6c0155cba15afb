#include "game/controls/tick_clock.h"

#include <gtest/gtest.h>

namespace game::test {
namespace {

constexpr double kClockTick = 1.0 / 60;

// Ticks of `seconds` at so many frames a second, all of them done.
int ticks_of(TickClock& clock, double seconds, double frames_per_second) {
    int ticks = 0;
    for (int frame = 0; frame < static_cast<int>(seconds * frames_per_second + 0.5); ++frame)
        ticks += clock.ticks_due(1 / frames_per_second, kClockTick);
    return ticks;
}

TEST(TickClock, owes_the_same_ticks_at_any_frame_rate_and_speed) {
    for (double speed = TickClock::kSlowest; speed <= TickClock::kFastest; speed *= 2)
        for (const double rate : {7.0, 30.0, 59.94, 144.0, 1000.0}) {
            TickClock clock;
            clock.set_speed(speed);
            EXPECT_NEAR(ticks_of(clock, 20, rate), 20 * 60 * speed, 60 * speed / rate + 1)
                << speed << " " << rate;
            EXPECT_FALSE(clock.behind());
            EXPECT_DOUBLE_EQ(clock.reached_speed(), speed);
        }
}

TEST(TickClock, owes_nothing_while_paused_and_one_tick_per_step) {
    TickClock clock;
    clock.pause(true);
    EXPECT_EQ(ticks_of(clock, 5, 60), 0);
    clock.step_once();
    EXPECT_EQ(clock.ticks_due(0.001, kClockTick), 1);
    for (int i = 0; i < 3; ++i) clock.step_once();  // pressed faster than frames come
    EXPECT_EQ(clock.ticks_due(0.001, kClockTick), 3);
    clock.ticks_undone(2);  // too slow for all of them in one frame
    EXPECT_EQ(clock.ticks_due(0.001, kClockTick), 2);
    EXPECT_EQ(clock.ticks_due(0.001, kClockTick), 0);
    EXPECT_EQ(ticks_of(clock, 5, 60), 0);
    clock.pause(false);
    EXPECT_NEAR(ticks_of(clock, 1, 60), 60, 1);
}

TEST(TickClock, owes_its_ticks_in_a_pause_while_a_tool_works) {
    TickClock clock;
    clock.pause(true);
    int ticks = 0;
    for (int frame = 0; frame < 60; ++frame) ticks += clock.ticks_due(1.0 / 60, kClockTick, true);
    EXPECT_NEAR(ticks, 60, 1);
    EXPECT_EQ(ticks_of(clock, 5, 60), 0);
}

TEST(TickClock, keeps_its_speed_to_powers_of_two_in_its_range) {
    TickClock clock;
    for (const auto& [asked, got] : {std::pair{0.001, 0.125}, {0.9, 1.0}, {3.1, 4.0}, {1e9, 16.0}}) {
        clock.set_speed(asked);
        EXPECT_EQ(clock.speed(), got);
    }
}

TEST(TickClock, owes_the_ticks_of_its_speed_at_the_pace_that_the_world_asks_for) {
    for (const double pace : {0.5, 1.0, 4.0}) {
        TickClock clock;
        clock.set_speed(2);
        clock.set_pace(pace);
        EXPECT_NEAR(ticks_of(clock, 10, 60), 10 * 60 * 2 * pace, 1);
        EXPECT_FALSE(clock.behind());
        EXPECT_DOUBLE_EQ(clock.reached_speed(), 2 * pace);
        EXPECT_EQ(clock.speed(), 2);
    }
}

TEST(TickClock, slows_the_world_and_says_so_where_the_machine_cannot_keep_up) {
    TickClock clock;
    clock.set_speed(16);
    for (int frame = 0; frame < 120; ++frame) clock.ticks_undone(clock.ticks_due(1.0 / 60, kClockTick) - 4);
    EXPECT_TRUE(clock.behind());
    EXPECT_NEAR(clock.reached_speed(), 4, 0.1);
    // Ticks that were left undone do not come back later.
    EXPECT_EQ(clock.ticks_due(1.0 / 60, kClockTick), 16);
    for (int frame = 0; frame < 300; ++frame) clock.ticks_due(1.0 / 60, kClockTick);
    EXPECT_FALSE(clock.behind());
}

TEST(TickClock, takes_a_long_sleep_for_a_quarter_second_and_says_that_time_was_lost) {
    TickClock clock;
    EXPECT_EQ(clock.ticks_due(100, kClockTick), 15);
    EXPECT_TRUE(clock.behind());
}

}  // namespace
}  // namespace game::test
