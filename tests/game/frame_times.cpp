#include "game/controls/frame_times.h"

#include <gtest/gtest.h>

namespace game::test {
namespace {

FrameTime frame_of(float frame_ms, float solve_ms = 0, float worst_tick_ms = 0) {
    FrameTime frame;
    frame.frame_ms = frame_ms;
    frame.stage_ms[stage_index(Stage::kSolve)] = solve_ms;
    frame.worst_tick_ms = worst_tick_ms;
    return frame;
}

TEST(FrameTimes, say_nothing_of_frames_there_were_none_of) {
    const FrameTimes times;
    EXPECT_EQ(times.size(), 0u);
    EXPECT_EQ(times.frames_per_second(), 0);
    EXPECT_EQ(times.median_ms(Stage::kDraw), 0);
    EXPECT_EQ(times.worst_tick_ms(), 0);
}

TEST(FrameTimes, keep_the_last_frames_oldest_first) {
    FrameTimes times;
    for (std::size_t i = 0; i < FrameTimes::kKept + 3; ++i) times.add(frame_of(static_cast<float>(i)));
    ASSERT_EQ(times.size(), FrameTimes::kKept);
    EXPECT_EQ(times[0].frame_ms, 3);
    EXPECT_EQ(times[FrameTimes::kKept - 1].frame_ms, static_cast<float>(FrameTimes::kKept + 2));
}

TEST(FrameTimes, count_frames_of_the_last_second_alone) {
    FrameTimes times;
    for (int i = 0; i < 10; ++i) times.add(frame_of(500));
    EXPECT_DOUBLE_EQ(times.frames_per_second(), 2);
    for (int i = 0; i < 100; ++i) times.add(frame_of(10));
    EXPECT_DOUBLE_EQ(times.frames_per_second(), 100);
}

// The first frame lasts from loading to the first event, which is no time at all.
TEST(FrameTimes, are_no_rate_before_a_tenth_of_a_second_has_passed) {
    FrameTimes times;
    times.add(frame_of(0.006f));
    EXPECT_EQ(times.frames_per_second(), 0);
    times.add(frame_of(60));
    EXPECT_EQ(times.frames_per_second(), 0);
    times.add(frame_of(60));
    EXPECT_NEAR(times.frames_per_second(), 25, 0.1);
}

TEST(FrameTimes, are_told_by_a_median_that_one_hiccup_does_not_move) {
    FrameTimes times;
    for (const float ms : {3.f, 1.f, 900.f, 2.f, 4.f}) times.add(frame_of(16, ms));
    EXPECT_EQ(times.median_ms(Stage::kSolve), 3);
    EXPECT_EQ(times.median_ms(Stage::kDraw), 0);
}

TEST(FrameTimes, remember_the_worst_tick_for_a_second) {
    FrameTimes times;
    times.add(frame_of(16, 0, 30));
    for (int i = 1; i < 62; ++i) times.add(frame_of(16, 0, 5));
    EXPECT_EQ(times.worst_tick_ms(), 30);
    for (int i = 0; i < 2; ++i) times.add(frame_of(16, 0, 5));
    EXPECT_EQ(times.worst_tick_ms(), 5);
}

// After a pause, frames take much longer at once: no number may be of the time before.
TEST(FrameTimes, measure_one_and_the_same_second) {
    FrameTimes times;
    for (std::size_t i = 0; i < FrameTimes::kKept; ++i) times.add(frame_of(16, 1, 1));
    for (int i = 0; i < 2; ++i) {
        FrameTime slow = frame_of(900, 600, 300);
        slow.ticks = 3;
        times.add(slow);
    }
    EXPECT_NEAR(times.frames_per_second(), 1000.0 / 900, 1e-6);
    EXPECT_EQ(times.median_ms(Stage::kSolve), 600);
    EXPECT_EQ(times.median_rest_ms(), 300);
    EXPECT_EQ(times.worst_tick_ms(), 300);
    EXPECT_EQ(times.ticks_per_frame(), 3);
}

}  // namespace
}  // namespace game::test
