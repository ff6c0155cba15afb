#include "game/controls/gamepad.h"

#include <set>

#include <gtest/gtest.h>

#include "game/controls/input.h"

namespace game::test {
namespace {

// A gamepad, and what came of it in the last frame.
class GamepadTest : public testing::Test {
  protected:
    void frame() {
        events_.clear();
        actions_.clear();
        gamepad_.take(state_,
                      {.screen = {800, 600, 1}, .flies = flies_, .in_panels = in_panels_, .elapsed_s = 0.02},
                      events_, actions_);
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) frame();
    }
    void hold(PadButton button, bool down = true) {
        state_->buttons[static_cast<std::size_t>(button)] = down;
        frame();
    }
    void push(PadAxis axis, float value) { state_->axes[static_cast<std::size_t>(axis)] = value; }
    template <class T>
    const T* event() const {
        for (const Event& each : events_)
            if (const T* const found = std::get_if<T>(&each)) return found;
        return nullptr;
    }
    std::optional<Verb> verb() const {
        if (actions_.size() != 1) return std::nullopt;
        const Verb* const only = std::get_if<Verb>(&actions_[0]);
        return only ? std::optional(*only) : std::nullopt;
    }

    std::optional<PadState> state_ = PadState{};
    bool flies_ = false, in_panels_ = false;
    Gamepad gamepad_;
    std::vector<Event> events_;
    Actions actions_;
};

TEST_F(GamepadTest, does_nothing_at_rest_or_with_a_worn_stick) {
    frames(3);
    EXPECT_TRUE(events_.empty() && actions_.empty());
    EXPECT_TRUE(gamepad_.is_there());
    EXPECT_FALSE(gamepad_.in_use());
    for (const PadAxis axis : {PadAxis::kLeftX, PadAxis::kLeftY, PadAxis::kRightX, PadAxis::kRightY})
        push(axis, 0.1f);
    frames(3);
    EXPECT_TRUE(events_.empty());
    EXPECT_EQ(gamepad_.turn(), glm::dvec2(0, 0));
    EXPECT_FALSE(gamepad_.in_use());
}

TEST_F(GamepadTest, moves_the_cursor_from_the_middle_and_keeps_it_on_the_screen) {
    push(PadAxis::kLeftX, 1);
    push(PadAxis::kLeftY, -1);  // up
    frame();
    const auto* const moved = event<MoveEvent>();
    ASSERT_TRUE(moved);
    EXPECT_GT(moved->x, 400);
    EXPECT_LT(moved->y, 300);
    frames(300);
    ASSERT_TRUE(event<MoveEvent>());
    EXPECT_EQ(event<MoveEvent>()->x, 799);
    EXPECT_EQ(event<MoveEvent>()->y, 0);
}

TEST_F(GamepadTest, presses_by_a_and_by_the_trigger_and_ends_with_what_it_began) {
    push(PadAxis::kLeftTrigger, 1);
    hold(PadButton::kA);
    ASSERT_TRUE(event<ButtonEvent>());
    EXPECT_TRUE(event<ButtonEvent>()->down);
    EXPECT_TRUE(event<ButtonEvent>()->with.control) << "the tool does the opposite";
    push(PadAxis::kLeftTrigger, -1);
    push(PadAxis::kRightTrigger, 1);
    hold(PadButton::kA, false);
    EXPECT_FALSE(event<ButtonEvent>()) << "the trigger still holds";
    push(PadAxis::kRightTrigger, -1);
    frame();
    ASSERT_TRUE(event<ButtonEvent>());
    EXPECT_FALSE(event<ButtonEvent>()->down);
    EXPECT_TRUE(event<ButtonEvent>()->with.control);
}

TEST_F(GamepadTest, turns_the_view_zooms_and_flies) {
    push(PadAxis::kRightX, 1);
    frame();
    EXPECT_GT(gamepad_.turn().x, 0);
    EXPECT_EQ(gamepad_.turn().y, 0);
    hold(PadButton::kUp);
    ASSERT_TRUE(event<WheelEvent>());
    EXPECT_GT(event<WheelEvent>()->steps, 0);
    hold(PadButton::kUp, false);
    push(PadAxis::kLeftY, -1);
    flies_ = true;
    frame();
    EXPECT_FALSE(event<MoveEvent>());
    EXPECT_EQ(gamepad_.walk(), glm::dvec2(0, 1));
}

TEST_F(GamepadTest, acts_once_per_press_and_goes_back_in_the_menu) {
    frame();
    hold(PadButton::kX);
    EXPECT_EQ(verb(), Verb::kPauseOrGoOn);
    frame();
    EXPECT_TRUE(actions_.empty());
    hold(PadButton::kX, false);
    in_panels_ = true;
    hold(PadButton::kX);
    EXPECT_TRUE(actions_.empty());
    hold(PadButton::kB);
    EXPECT_EQ(verb(), Verb::kClosePanel);
    hold(PadButton::kStart);
    EXPECT_EQ(verb(), Verb::kMenu);
}

TEST_F(GamepadTest, chooses_on_a_wheel_what_a_stick_points_at) {
    frame();
    hold(PadButton::kLeftBumper);
    ASSERT_TRUE(gamepad_.wheel());
    EXPECT_FALSE(gamepad_.wheel()->chosen);
    push(PadAxis::kRightX, 0.9f);  // to the right: a quarter of the way round
    frame();
    EXPECT_EQ(gamepad_.wheel()->chosen, (kTools + 2) / 4);
    EXPECT_EQ(gamepad_.turn(), glm::dvec2(0, 0)) << "the stick does nothing else";
    push(PadAxis::kRightX, 0);
    frame();
    hold(PadButton::kLeftBumper, false);
    ASSERT_EQ(actions_.size(), 1u);
    EXPECT_EQ(std::get<Tool>(actions_[0]), static_cast<Tool>((kTools + 2) / 4));
    EXPECT_FALSE(gamepad_.wheel());

    hold(PadButton::kRightBumper);
    hold(PadButton::kRightBumper, false);
    EXPECT_TRUE(actions_.empty()) << "nothing was pointed at";
    hold(PadButton::kRightBumper);
    push(PadAxis::kLeftY, -1);
    frame();
    hold(PadButton::kRightBumper, false);
    EXPECT_EQ(verb(), Verb::kUsualSpeed);
}

TEST_F(GamepadTest, lets_everything_go_when_it_is_drawn_out_while_it_acts) {
    push(PadAxis::kLeftX, 1);
    hold(PadButton::kA);
    hold(PadButton::kLeftBumper);
    ASSERT_TRUE(gamepad_.wheel());
    state_.reset();
    frame();
    ASSERT_TRUE(event<ButtonEvent>());
    EXPECT_FALSE(event<ButtonEvent>()->down);
    EXPECT_TRUE(actions_.empty());
    EXPECT_FALSE(gamepad_.wheel() || gamepad_.is_there() || gamepad_.in_use());
    frame();
    EXPECT_TRUE(events_.empty());
    state_ = PadState{};  // another one
    frame();
    EXPECT_TRUE(gamepad_.is_there());
    EXPECT_TRUE(events_.empty() && actions_.empty());
}

TEST_F(GamepadTest, stays_calm_whatever_the_device_reports) {
    for (const float odd :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -5.f, 5.f}) {
        state_->axes.fill(odd);
        frames(3);
        for (const Event& each : events_)
            if (const auto* const move = std::get_if<MoveEvent>(&each)) {
                EXPECT_TRUE(move->x >= 0 && move->x < 800 && move->y >= 0 && move->y < 600);
            }
        EXPECT_LE(glm::length(gamepad_.turn()), 0.1);
    }
}

TEST(GamepadNames, say_of_each_button_one_thing_and_name_its_verb) {
    std::set<PadButton> buttons;
    for (const PadBinding& binding : pad_bindings()) {
        EXPECT_TRUE(buttons.insert(binding.button).second) << binding.name;
        EXPECT_EQ(pad_name_of(binding.does), binding.name);
        EXPECT_FALSE(binding.meaning.empty());
    }
    EXPECT_EQ(pad_name_of(Verb::kQuit), "");
    EXPECT_EQ(choices_of(PadWheel::kTools).size(), kTools);
}

TEST(GamepadNames, replace_those_of_keys_while_it_is_in_use) {
    const KeyboardLayout layout;
    const KeyMap map;
    EXPECT_EQ(name_of(Keys{layout, map}, Verb::kRunBack), "Backspace");
    EXPECT_EQ(name_of(Keys{layout, map, true}, Verb::kRunBack), "B");
    EXPECT_EQ(name_of(Keys{layout, map, true}, Verb::kShare), "F10") << "which has no button";
}

}  // namespace
}  // namespace game::test
