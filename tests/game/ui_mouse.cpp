#include <gtest/gtest.h>

#include "tests/game/ui_hand.h"

namespace game::test {
namespace {

constexpr double kBesideX = 640, kBesideY = 400;  // on the mountain

TEST_F(UiHand, keeps_the_mouse_over_a_panel_and_leaves_it_beside) {
    point_at("Pour");
    frame();
    EXPECT_TRUE(ui_->keeps_mouse());
    screen_.move(kBesideX, kBesideY);
    frame();
    EXPECT_FALSE(ui_->keeps_mouse());
}

TEST_F(UiHand, leaves_a_drag_to_the_mountain_on_which_it_began) {
    screen_.move(kBesideX, kBesideY);
    frame();
    screen_.press(Button::kLeft);
    frame();
    EXPECT_FALSE(ui_->keeps_mouse());
    point_at("Pour");
    settle(3);  // over a panel, still the mountain's
    EXPECT_FALSE(ui_->keeps_mouse());
    screen_.release(Button::kLeft);
    EXPECT_TRUE(frame().empty());
    EXPECT_TRUE(frame().empty());  // and no click on the panel
    EXPECT_TRUE(ui_->keeps_mouse());
}

TEST_F(UiHand, keeps_a_drag_that_began_on_a_panel) {
    point_at("Radius");
    frame();
    screen_.press(Button::kLeft);
    frame();
    screen_.move(kBesideX, kBesideY);
    frame();
    EXPECT_TRUE(ui_->keeps_mouse());
    screen_.release(Button::kLeft);
    frame();
    frame();
    EXPECT_FALSE(ui_->keeps_mouse());
}

TEST_F(UiHand, sees_a_press_and_release_within_one_frame) {
    point_at("Dig");
    screen_.press(Button::kLeft);
    screen_.release(Button::kLeft);
    Actions all;
    for (int i = 0; i < 4; ++i)
        for (const Action& action : frame()) all.push_back(action);
    EXPECT_EQ(only<Tool>(all), Tool::kDig);
}

TEST_F(UiHand, clicks_where_the_button_went_down_though_the_cursor_has_gone_on_in_the_same_frame) {
    point_at("Dig");
    screen_.press(Button::kLeft);
    screen_.release(Button::kLeft);
    screen_.move(kBesideX, kBesideY);
    Actions all;
    for (int i = 0; i < 5; ++i)
        for (const Action& action : frame()) all.push_back(action);
    EXPECT_EQ(only<Tool>(all), Tool::kDig);
    EXPECT_FALSE(ui_->keeps_mouse());
}

TEST_F(UiHand, does_nothing_with_a_button_that_was_held_when_the_focus_went) {
    point_at("Dig");
    frame();
    screen_.press(Button::kLeft);
    frame();
    screen_.happen({FocusEvent{false}});
    settle(3);
    EXPECT_FALSE(ui_->keeps_mouse());
    screen_.happen({FocusEvent{true}});
    point_at("Dig");
    screen_.release(Button::kLeft);
    settle(3);
}

TEST_F(UiHand, scrolls_a_panel_that_does_not_fit) {
    begin_anew({1280, 420, 1});
    ui_->perform(Verb::kTogglePhysics);
    settle();
    EXPECT_FALSE(ui_->find("All defaults"));
    point_at("start slope");
    frame();
    for (int i = 0; i < 40; ++i) {
        screen_.happen({WheelEvent{-1, {}}});
        frame();
    }
    EXPECT_TRUE(ui_->find("All defaults"));
}

}  // namespace
}  // namespace game::test
