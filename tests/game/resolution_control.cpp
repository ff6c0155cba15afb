#include "game/controls/resolution_control.h"

#include <algorithm>
#include <functional>
#include <set>

#include <gtest/gtest.h>

namespace game::test {
namespace {

constexpr double kPixels = 1280 * 720;

// A machine that draws frames, one after the other.
class ResolutionControls : public testing::Test {
  protected:
    // Draws a frame whose time is that of its scale; returns the scale.
    double frame(bool camera_moved, const std::function<double(double)>& draw_ms, double rest_ms = 4) {
        const double scale = control.scale_for({now_s, camera_moved, pixels}, limits);
        const double ms = draw_ms(scale);
        control.drew(ms, rest_ms);
        now_s += (ms + rest_ms) / 1000;
        changes += scale != last;
        last = scale;
        return scale;
    }
    double frames(int count, bool camera_moved, const std::function<double(double)>& draw_ms,
                  double rest_ms = 4) {
        for (int i = 0; i < count; ++i) frame(camera_moved, draw_ms, rest_ms);
        return last;
    }
    // Drawing that takes `fixed` ms, and `whole` more for all pixels of the screen.
    static std::function<double(double)> costing(double fixed, double whole) {
        return [=](double scale) { return fixed + whole * scale * scale; };
    }

    ResolutionControl control;
    ResolutionControl::Limits limits;
    double now_s = 0, pixels = kPixels, last = 0;
    int changes = 0;
};

TEST_F(ResolutionControls, draw_everything_where_there_is_time) {
    EXPECT_EQ(frames(60, true, costing(2, 4)), 1);
    EXPECT_EQ(frames(100, false, costing(2, 4)), 1);
}

TEST_F(ResolutionControls, meet_the_target_at_the_largest_scale_that_does) {
    for (const double whole : {20., 40., 70., 100., 200., 400.}) {
        control = {};
        const auto cost = costing(5, whole);
        const double scale = frames(300, true, cost);
        EXPECT_TRUE(cost(scale) + 4 <= 33 || scale == kScales.back()) << whole;
        for (const double other : kScales) {
            EXPECT_TRUE(cost(other) + 4 > 0.75 * 33 || other <= scale) << whole << " " << scale;
        }
    }
}

TEST_F(ResolutionControls, have_another_least_while_the_camera_stands) {
    limits.least_of_world = 0.75;
    EXPECT_EQ(frames(300, true, costing(5, 800)), 0.25);
    EXPECT_EQ(frames(300, false, costing(5, 800)), 0.75);
    EXPECT_EQ(frames(300, true, costing(5, 800)), 0.25);
}

TEST_F(ResolutionControls, settle_and_do_not_flicker) {
    for (double whole = 10; whole < 500; whole *= 1.17) {
        control = {};
        frames(200, true, costing(5, whole));
        changes = 0;
        frames(400, true, costing(5, whole));
        EXPECT_EQ(changes, 0) << whole;
    }
}

TEST_F(ResolutionControls, do_not_flicker_where_times_vary_by_a_tenth) {
    frames(100, true, costing(5, 70));
    changes = 0;
    for (int i = 0; i < 1000; ++i)
        frame(true,
              [&](double scale) { return (5 + 70 * scale * scale) * (1 + 0.1 * ((i * 7 % 5) - 2) / 2); });
    EXPECT_LE(changes, 1);
}

TEST_F(ResolutionControls, ignore_one_slow_frame) {
    const double before = frames(100, true, costing(5, 70));
    changes = 0;
    for (int i = 0; i < 20; ++i) {
        frame(true, costing(900, 70));
        frames(8, true, costing(5, 70));
    }
    EXPECT_EQ(last, before);
    EXPECT_EQ(changes, 0);
}

TEST_F(ResolutionControls, fall_in_one_step_within_four_frames_if_drawing_becomes_dear) {
    ASSERT_EQ(frames(100, true, costing(2, 10)), 1);
    changes = 0;
    EXPECT_LE(frames(5, true, costing(2, 150)), 0.375);
    EXPECT_EQ(changes, 1);
}

TEST_F(ResolutionControls, recover_when_drawing_becomes_cheap) {
    ASSERT_LE(frames(100, true, costing(2, 200)), 0.375);
    EXPECT_EQ(frames(120, true, costing(2, 10)), 1);
}

TEST_F(ResolutionControls, keep_a_scale_for_the_camera_and_one_for_the_world) {
    const auto all = costing(5, 70), part = costing(5, 8);
    ASSERT_LE(frames(100, true, all), 0.5);
    const double camera = last;
    EXPECT_EQ(frames(200, false, part), 1);
    EXPECT_EQ(frames(1, true, all), camera) << "at once, because its scale is known";
    frames(100, true, all);
    EXPECT_EQ(control.world_scale(), 1);
    frames(30, false, part);  // the hand may go on
    EXPECT_EQ(last, 1) << "at once";
}

TEST_F(ResolutionControls, raise_the_scale_of_the_world_at_most_once_a_second) {
    frames(50, true, costing(5, 70));
    now_s += 1;
    changes = 0;
    for (int second = 0; second < 4; ++second) {
        const int before = changes;
        frames(30, false, costing(2, 2));
        EXPECT_LE(changes, before + 1);
    }
}

TEST_F(ResolutionControls, hold_the_size_while_a_hand_drags_in_jerks) {
    frames(100, true, costing(5, 70));
    frames(200, false, costing(5, 8));
    frame(true, costing(5, 70));
    changes = 0;
    for (int i = 0; i < 200; ++i) frame(i % 4 == 0, i % 4 == 0 ? costing(5, 70) : costing(5, 8));
    EXPECT_EQ(changes, 0);
}

TEST_F(ResolutionControls, stay_within_their_limits) {
    limits.least = 0.75;
    EXPECT_EQ(frames(100, true, costing(5, 900)), 0.75);
    limits = {.target_ms = 33, .least = 0.25, .most = 0.5};
    EXPECT_EQ(frames(100, true, costing(1, 1)), 0.5);
    limits = {.target_ms = 33, .least = 0.5, .most = 0.5};
    EXPECT_EQ(frames(100, true, costing(5, 900)), 0.5);
}

// Where most of the time does not depend on pixels, a blur would gain nothing.
TEST_F(ResolutionControls, keep_a_scale_if_a_smaller_one_saves_next_to_nothing) {
    EXPECT_EQ(frames(200, true, costing(40, 20)), 0.5);
    changes = 0;
    frames(600, true, costing(40, 20));
    EXPECT_EQ(changes, 0);
    EXPECT_LE(frames(1200, true, costing(2, 150)), 0.375) << "what was learned is forgotten";
}

// A flow that grows costs more at each smaller scale, as if they saved nothing.
TEST_F(ResolutionControls, fall_further_while_more_and_more_of_the_world_moves) {
    double whole = 20;
    for (int i = 0; i < 200; ++i, whole *= 1.02)
        frame(false, [&](double scale) { return 4 + std::min(whole, 100.) * scale * scale; });
    EXPECT_LE(4 + 100 * last * last + 4, 33);
}

TEST_F(ResolutionControls, follow_the_target) {
    limits.target_ms = 100;
    const double slow = frames(200, true, costing(5, 70));
    EXPECT_EQ(slow, 1);
    limits.target_ms = 16;
    EXPECT_LT(frames(100, true, costing(5, 70)), 0.5);
}

// A solver that is slower than the target must not make the image a blur: it would gain nothing.
TEST_F(ResolutionControls, leave_half_of_the_target_to_drawing) {
    EXPECT_EQ(frames(200, false, costing(2, 8), 80), 1);
}

TEST_F(ResolutionControls, fall_at_once_when_the_window_becomes_large) {
    frames(100, true, costing(2, 20));
    ASSERT_EQ(last, 1);
    pixels = 50 * kPixels;
    EXPECT_EQ(frame(true, costing(2, 1000)), 0.25);
    pixels = kPixels;
    EXPECT_EQ(frames(200, true, costing(2, 20)), 1);
}

TEST_F(ResolutionControls, work_on_one_pixel_and_with_times_of_zero) {
    pixels = 1;
    EXPECT_EQ(frames(100, true, costing(0, 0), 0), 1);
    pixels = 8000. * 8000;
    EXPECT_EQ(frames(100, false, costing(0, 0), 0), 1);
}

}  // namespace
}  // namespace game::test
