#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "game/app/languages.h"
#include "game/ui/ui.h"
#include "tests/support/scripted_screen.h"
#include "tests/support/worlds.h"

namespace game::test {

// Panels over a small world, and a hand that clicks and types. No GL: frames are built, never drawn.
class UiHand : public testing::Test {
  protected:
    UiHand();

    // One frame; returns what was asked in it.
    Actions frame();
    // So many frames, so that windows have their final size and place.
    void settle(int frames = 4);

    // The middle of a widget of the last frame; fails the test where it was not seen.
    ui::Ui::Place place(std::string_view label);
    void point_at(std::string_view label);
    // Moves to a widget, presses and releases: all that was asked meanwhile.
    Actions click(std::string_view label);
    // Clicks into a field of numbers, types over what stands there, ends with Enter.
    Actions type_into(std::string_view label, std::string_view text);

    ui::Facts facts() const;
    // Replaces the panels: at another size, say. Without a font they have ImGui's own.
    void begin_anew(ScreenSize size, const std::optional<std::filesystem::path>& font = std::nullopt);

    support::ScriptedScreen screen_;
    Scenario scenario_;
    sim::State state_;
    TickClock clock_;
    Brush brush_;
    Display display_;
    FrameTimes times_;
    Notices notices_;
    Catalogue catalogue_;
    KeyMap keys_;
    Languages languages_;
    Modifiers modifiers_;
    bool touched_ = false;
    std::size_t actions_to_undo_ = 0, actions_to_redo_ = 0;
    std::optional<Reading> under_cursor_;
    CameraMode camera_mode_ = CameraMode::kOrbit;
    ui::Timeline timeline_;
    std::string recording_ = "/tmp/valley.couloir";
    std::optional<double> sharing_, filming_;
    ui::PathNote path_;
    std::optional<ui::SectionNote> section_;
    std::optional<ui::PhotoNote> photo_;
    const SlideHistory* history_ = nullptr;
    std::vector<ui::SlideLabel> slide_labels_;
    std::optional<ui::Compass> compass_;
    std::vector<BestRun> best_runs_;
    std::optional<ui::ResultCard> card_;
    std::optional<GoalUse> goal_use_;
    std::optional<ui::LessonNote> lesson_;
    std::vector<ui::LessonMark> lesson_marks_;
    std::optional<ui::Ui> ui_;
};

// The one action there is, if it is a T; else the test fails.
template <class T>
T only(const Actions& actions) {
    EXPECT_EQ(actions.size(), 1u);
    if (actions.size() == 1 && std::holds_alternative<T>(actions[0])) return std::get<T>(actions[0]);
    ADD_FAILURE() << "not what was expected to be asked";
    return {};
}

}  // namespace game::test
