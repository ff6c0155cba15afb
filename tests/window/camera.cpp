#include <algorithm>
#include <initializer_list>

#include <gtest/gtest.h>

#include "tests/window/play_session.h"
#include "tests/window/screenshot.h"

// Camera controls on a paused world.
namespace game::test {
namespace {

constexpr int kX = PlaySession::kMiddleX, kY = PlaySession::kMiddleY;
constexpr double kPart = 0.7;   // of the window, away from what stands in its corners
constexpr double kSame = 0.01;  // of the pixels that may differ by a moved ring or arrow
constexpr double kOther = 0.10;
constexpr int kSameShots = 6;  // 0.4 s apart, until the image counts as finished

class CameraInTheWindow : public testing::Test {
  protected:
    void SetUp() override {
        if (const auto missing = missing_for_a_desktop()) GTEST_SKIP() << *missing;
        session.emplace();
        hand().key("space");
        ASSERT_TRUE(within(5, [&] { return session->stands(); })) << "it is not paused";
        hand().key("Home");
        start = at_rest();
    }
    void TearDown() override {
        if (!session) return;
        EXPECT_EQ(session->commands(), 0u) << "a camera move has changed the world";
        EXPECT_EQ(session->tick(), tick) << "a camera move has advanced time";
        session->leave();
    }

    XSession& hand() { return session->hand(); }

    // The image once the camera has stopped and the finished image (App::draw_world) has replaced the
    // moving one, with the pointer at the same place. A slow machine takes a second to finish it.
    render::Picture at_rest() {
        hand().move(kX, kY);
        render::Picture before = middle(hand().screenshot(), kPart), now;
        int same = 0;
        EXPECT_TRUE(within(30, [&] {
            rest(0.4);
            now = middle(hand().screenshot(), kPart);
            same = difference(std::exchange(before, now), now) == 0 ? same + 1 : 0;
            return same == kSameShots;
        })) << "the image does not come to rest";
        tick = session->tick();
        return now;
    }

    // Soon, and while the camera may still move.
    void expect_other_than(std::initializer_list<render::Picture> others) {
        EXPECT_TRUE(within(30, [&] {
            const render::Picture now = middle(hand().screenshot(), kPart);
            return std::ranges::all_of(others,
                                       [&](const auto& other) { return difference(now, other) > kOther; });
        }));
    }

    void expect_home_leads_back() {
        hand().key("Home");
        EXPECT_LT(difference(at_rest(), start), kSame);
    }

    std::optional<PlaySession> session;
    render::Picture start;
    std::int64_t tick = -1;
};

TEST_F(CameraInTheWindow, turns_with_the_right_button) {
    hand().press(Mouse::kRight);
    hand().drag(kX + 120, kY);
    hand().release(Mouse::kRight);
    expect_other_than({start});
    expect_home_leads_back();
}

TEST_F(CameraInTheWindow, pans_with_the_middle_button_and_with_shift_and_the_right_one) {
    hand().press(Mouse::kMiddle);
    hand().drag(kX + 80, kY + 40);
    hand().release(Mouse::kMiddle);
    expect_other_than({start});
    expect_home_leads_back();
    hand().key_down("Shift_L");
    hand().press(Mouse::kRight);
    hand().drag(kX + 80, kY + 40);
    hand().release(Mouse::kRight);
    hand().key_up("Shift_L");
    expect_other_than({start});
}

TEST_F(CameraInTheWindow, zooms_with_the_wheel) {
    hand().wheel(4);
    const render::Picture near = at_rest();
    EXPECT_GT(difference(near, start), kOther);
    hand().wheel(-8);
    expect_other_than({near, start});
    expect_home_leads_back();
}

TEST_F(CameraInTheWindow, looks_straight_down_and_back) {
    hand().key("t");
    expect_other_than({start});
    hand().key("t");
    EXPECT_LT(difference(at_rest(), start), kSame);
}

TEST_F(CameraInTheWindow, flies_by_the_keys_that_are_held) {
    hand().key("f");
    const render::Picture still = at_rest();
    hand().key_down("w");
    rest(0.6);
    hand().key_up("w");
    expect_other_than({still});
}

}  // namespace
}  // namespace game::test
