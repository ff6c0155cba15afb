#include <gtest/gtest.h>

#include "tests/game/ui_hand.h"
#include "tests/support/layouts.h"

namespace game::test {
namespace {

TEST_F(UiHand, asks_for_nothing_while_nobody_touches_it) {
    settle(30);
}

TEST_F(UiHand, asks_for_the_tool_that_is_clicked) {
    EXPECT_EQ(only<Tool>(click("Dig")), Tool::kDig);
    EXPECT_EQ(only<Tool>(click("Blast")), Tool::kBlast);
    EXPECT_EQ(only<Tool>(click("Pour")), Tool::kPour);
}

TEST_F(UiHand, asks_for_what_the_time_bar_says) {
    EXPECT_EQ(only<Verb>(click("Pause")), Verb::kPauseOrGoOn);
    EXPECT_EQ(only<Verb>(click("Step")), Verb::kStepOnce);
    EXPECT_EQ(only<Verb>(click("Reset")), Verb::kReset);
    EXPECT_EQ(only<Verb>(click("Rewind")), Verb::kRunBack);
    clock_.pause(true);
    frame();
    EXPECT_FALSE(ui_->find("Pause"));
    EXPECT_EQ(only<Verb>(click("Resume")), Verb::kPauseOrGoOn);
}

TEST_F(UiHand, shares_a_slide_and_shows_how_much_of_its_page_is_done) {
    EXPECT_EQ(only<Verb>(click("Share")), Verb::kShare);
    EXPECT_FALSE(ui_->find("Sharing"));
    sharing_ = 0.4;
    settle();
    EXPECT_TRUE(ui_->find("Sharing"));
    EXPECT_TRUE(click("Share").empty()) << "one at a time";
    ui_->perform(Verb::kTogglePanels);
    settle();
    EXPECT_FALSE(ui_->find("Sharing"));
}

TEST_F(UiHand, seeks_along_the_timeline_for_as_long_as_it_is_held) {
    timeline_ = {.known_until = 600};
    settle();
    const ui::Ui::Place bar = place("Timeline");
    point_at("Timeline");
    frame();
    screen_.press(Button::kLeft);
    frame();
    const auto tick = only<SeekTick>(frame()).tick;
    EXPECT_NEAR(static_cast<double>(tick), 300, 3);
    screen_.move(bar.x + 0.7 * bar.width, bar.y + 5);
    frame();
    EXPECT_GT(only<SeekTick>(frame()).tick, tick);
    screen_.move(bar.x + 3 * bar.width, bar.y + 5);
    frame();
    EXPECT_EQ(only<SeekTick>(frame()).tick, 600);
    screen_.release(Button::kLeft);
    frame();
    EXPECT_TRUE(frame().empty());
    timeline_.can_go_back = false;
    settle();
    EXPECT_FALSE(ui_->find("Timeline"));
    EXPECT_TRUE(click("Rewind").empty());
}

TEST_F(UiHand, asks_for_each_speed_that_is_chosen) {
    EXPECT_TRUE(click("Speed").empty());
    EXPECT_EQ(only<SetSpeed>(click("1/8 ×")).speed, 0.125);
    EXPECT_TRUE(click("Speed").empty());
    EXPECT_EQ(only<SetSpeed>(click("16 ×")).speed, 16);
}

TEST_F(UiHand, undoes_only_where_there_is_something_to_undo) {
    EXPECT_TRUE(click("Undo").empty());
    actions_to_undo_ = 1;
    EXPECT_EQ(only<Verb>(click("Undo")), Verb::kUndo);
    EXPECT_TRUE(click("Redo").empty());
    actions_to_redo_ = 1;
    EXPECT_EQ(only<Verb>(click("Redo")), Verb::kRedo);
}

TEST_F(UiHand, pours_standing_or_rolling_by_the_button_that_is_not_on) {
    EXPECT_TRUE(click("Rolling").empty());
    EXPECT_EQ(only<Verb>(click("Standing")), Verb::kPourStandingOrRolling);
    brush_.standing = true;
    EXPECT_TRUE(click("Standing").empty());
    EXPECT_EQ(only<Verb>(click("Rolling")), Verb::kPourStandingOrRolling);
}

TEST_F(UiHand, chooses_which_of_two_materials_is_poured) {
    EXPECT_FALSE(ui_->find("dry sand"));
    scenario_.lower.emplace();
    scenario_.lower->material = "sand";
    settle();
    EXPECT_TRUE(click("loose dry snow").empty());
    brush_ = only<SetBrush>(click("dry sand")).brush;
    EXPECT_EQ(brush_.of, sim::Part::kLower);
    EXPECT_TRUE(click("dry sand").empty());
    EXPECT_EQ(only<SetBrush>(click("loose dry snow")).brush.of, sim::Part::kUpper);
    begin_anew({640, 360, 1});
    for (const char* label : {"loose dry snow", "dry sand"}) {
        const auto at = place(label);
        EXPECT_GE(at.x, 0) << label;
        EXPECT_LE(at.x + at.width, 640) << label;
    }
}

TEST_F(UiHand, sets_radius_and_strength_of_the_brush_by_sliding) {
    const auto at = place("Radius");
    screen_.move(at.x + at.width * 0.75, at.y + at.height / 2);
    frame();
    screen_.press(Button::kLeft);
    const Brush larger = only<SetBrush>(frame()).brush;
    EXPECT_GT(larger.radius, brush_.radius);
    EXPECT_EQ(larger.numbers, brush_.numbers);
    brush_ = larger;
    screen_.release(Button::kLeft);
    settle();

    brush_.tool = Tool::kBlast;
    frame();
    const auto strength = place("Strength");
    screen_.move(strength.x + 2, strength.y + strength.height / 2);
    frame();
    screen_.press(Button::kLeft);
    const Brush weaker = only<SetBrush>(frame()).brush;
    EXPECT_DOUBLE_EQ(weaker.own()[0], info_of(Tool::kBlast).numbers[0].least);
    EXPECT_EQ(weaker.numbers[0], brush_.numbers[0]);
    EXPECT_EQ(weaker.radius, brush_.radius);
}

// The decimal key of many keypads types a comma.
TEST_F(UiHand, takes_a_comma_for_the_point_in_a_number_that_is_typed_or_pasted_into_a_slider) {
    const auto open_for_typing = [&] {
        point_at("Radius");
        frame();
        screen_.press(Button::kLeft, {.control = true});
        frame();
        screen_.release(Button::kLeft);
        settle();
    };
    const auto enter = [&] {
        screen_.tap(Key::kEnter);
        Actions asked;
        for (int i = 0; i < 4; ++i)
            for (const Action& action : frame()) asked.push_back(action);
        return asked;
    };
    open_for_typing();
    screen_.type("6,5");
    EXPECT_EQ(only<SetBrush>(enter()).brush.radius, 6.5);

    open_for_typing();
    screen_.set_clipboard("7,25");
    screen_.tap(key('V'), {.control = true});
    EXPECT_EQ(only<SetBrush>(enter()).brush.radius, 7.25);
}

TEST_F(UiHand, names_the_keys_of_the_keyboard_in_use) {
    ui_->perform(Verb::kToggleHelp);
    settle();
    EXPECT_TRUE(ui_->find("key Shift+["));
    EXPECT_FALSE(ui_->find("key Shift+Ü"));
    screen_.have(support::layout("de"));
    settle();
    EXPECT_TRUE(ui_->find("key Ü"));
    EXPECT_TRUE(ui_->find("key Shift+Ü"));
    EXPECT_FALSE(ui_->find("key Shift+["));
}

TEST_F(UiHand, says_what_a_tool_does_while_control_is_held) {
    brush_.tool = Tool::kBlast;
    modifiers_.control = true;
    frame();
    EXPECT_TRUE(ui_->find("Settle"));
    EXPECT_FALSE(ui_->find("Blast"));
}

TEST_F(UiHand, greys_the_tools_while_a_recording_is_watched) {
    EXPECT_FALSE(ui_->find("Watching a recording"));
    timeline_ = {.known_until = 600, .watches = true};
    actions_to_undo_ = 2;
    settle();
    EXPECT_TRUE(ui_->find("Watching a recording"));
    for (const char* label : {"Dig", "Undo"}) EXPECT_TRUE(click(label).empty()) << label;
    for (const char* option : {"Standing", "Radius"}) EXPECT_FALSE(ui_->find(option)) << option;
    EXPECT_EQ(only<Verb>(click("Pause")), Verb::kPauseOrGoOn);
    EXPECT_EQ(only<Verb>(click("Continue from here")), Verb::kTakeOver);
}

TEST_F(UiHand, says_when_the_machine_cannot_keep_up) {
    EXPECT_TRUE(ui_->find("at rest"));
    for (int i = 0; i < 60; ++i) {
        clock_.ticks_due(0.1, 1.0 / 60);
        clock_.ticks_undone(4);
    }
    ASSERT_TRUE(clock_.behind());
    frame();
    EXPECT_FALSE(ui_->find("at rest"));
    EXPECT_TRUE(ui_->find("only 0.3 ×"));
}

TEST_F(UiHand, leaves_the_tick_out_where_a_long_time_leaves_no_room_for_it) {
    while (!clock_.behind()) {
        clock_.ticks_due(0.1, 1.0 / 60);
        clock_.ticks_undone(4);
    }
    for (state_.tick = 1; state_.tick < 1'000'000'000; state_.tick *= 10) {
        frame();
        const ui::Ui::Place time = place("Time"), pace = place("only 0.3 ×");
        EXPECT_LE(time.x + time.width, pace.x) << state_.tick;
        const std::optional<ui::Ui::Place> tick = ui_->find("Tick");
        if (state_.tick <= 100'000) {
            EXPECT_TRUE(tick) << state_.tick;
        }
        if (state_.tick >= 100'000'000) {
            EXPECT_FALSE(tick) << state_.tick;
        }
        EXPECT_LE(tick ? tick->x + tick->width : 0, pace.x) << state_.tick;
    }
}

TEST_F(UiHand, hints_at_the_brush_until_the_world_was_touched) {
    EXPECT_TRUE(ui_->find("Hint"));
    touched_ = true;
    frame();
    EXPECT_FALSE(ui_->find("Hint"));
}

TEST_F(UiHand, hints_at_nothing_while_something_moves_by_itself) {
    state_.ledger.rolling = 1;
    settle();
    EXPECT_FALSE(ui_->find("Hint"));
    state_.ledger.rolling = 0;
    settle();
    EXPECT_TRUE(ui_->find("Hint"));
}

TEST_F(UiHand, tells_word_and_key_of_each_tool_and_names_the_one_in_the_hand_at_every_width) {
    for (const ScreenSize size : {ScreenSize{1280, 720, 1}, {640, 480, 1}, {1280, 720, 2}}) {
        begin_anew(size);
        for (const ToolInfo& info : tool_infos()) {
            brush_.tool = info.tool;
            settle();
            const auto name = place("Name of the tool");
            EXPECT_GE(name.x, 0);
            EXPECT_LE(name.x + name.width, size.width);
        }
        brush_.tool = Tool::kPour;
    }
    begin_anew({1920, 1080, 1});
    EXPECT_FALSE(ui_->find("Name of the tool")) << "the buttons have words";
}

TEST_F(UiHand, offers_water_in_worlds_of_soil_without_a_taller_toolbar) {
    for (const ScreenSize size : {ScreenSize{1280, 720, 1}, {1280, 720, 2}, {1920, 1080, 1}}) {
        state_.params.density = 300;
        begin_anew(size);
        EXPECT_FALSE(ui_->find("Water")) << "in snow";
        const double tall = place("Tools").height;
        state_.params.density = 1800;
        settle();
        EXPECT_EQ(only<Tool>(click("Water")), Tool::kWater);
        EXPECT_EQ(place("Tools").height, tall) << size.width;
    }
}

TEST_F(UiHand, sets_the_strength_of_water_in_millimetres) {
    state_.params.density = 1800;
    brush_.tool = Tool::kWater;
    begin_anew({1920, 1080, 1});
    const double middle = only<SetBrush>(click("Strength")).brush.own()[0];
    EXPECT_NEAR(middle, 0.0525, 0.001);  // m/s, of 5 to 100 mm/s
}

TEST_F(UiHand, moves_no_button_for_another_material_or_tool_or_for_keys_that_are_held) {
    for (const ScreenSize size : {ScreenSize{640, 480, 1}, {1280, 720, 1}, {1920, 1080, 1}}) {
        begin_anew(size);
        const auto buttons = [&] {
            settle();
            std::vector<double> at;
            for (const char* label : {"Dig", "Lift", "Scene", "Help"}) at.push_back(place(label).x);
            return at;
        };
        const std::vector<double> before = buttons();
        scenario_.material = "a material with a very long name, from a file";
        EXPECT_EQ(buttons(), before);
        brush_.tool = Tool::kHouse;
        EXPECT_EQ(buttons(), before);
        modifiers_.control = true;
        EXPECT_EQ(buttons(), before);
        modifiers_ = {};
        brush_.tool = Tool::kPour;
    }
}

bool overlap(const ui::Ui::Place& a, const ui::Ui::Place& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

TEST_F(UiHand, shows_tooltips_beside_the_panels) {
    begin_anew({1280, 960, 1});
    timeline_ = {.known_until = 600};
    actions_to_undo_ = 1;
    for (const Verb verb : {Verb::kToggleDisplay, Verb::kTogglePerformance}) ui_->perform(verb);
    settle();
    for (const char* label :
         {"Pour", "Lift", "Continue from here", "Help", "Performance", "Display", "Close Performance",
          "Close Display", "Direction", "Contours", "Timeline", "Undo", "Mass"}) {
        point_at(label);
        settle(60);
        const ui::Ui::Place tooltip = place("Tooltip");
        for (const char* other :
             {label, "Toolbar", "Tool options", "Time bar", "Panel Display", "Panel Performance"})
            EXPECT_FALSE(overlap(tooltip, place(other))) << label << " over " << other;
        EXPECT_GE(tooltip.x, 0);
        EXPECT_LE(tooltip.x + tooltip.width, 1280);
    }
}

TEST_F(UiHand, reads_out_what_is_under_the_cursor_and_nothing_where_there_is_none) {
    EXPECT_FALSE(ui_->find("Slope"));
    under_cursor_.emplace();
    under_cursor_->slope_deg = 37;
    settle();
    for (const char* label :
         {"Height", "Slope", "Aspect", "Standing", "Rolling", "Speed on slope", "Speed in plan"})
        EXPECT_TRUE(ui_->find(label)) << label;
    EXPECT_FALSE(ui_->find("Mixture"));
    EXPECT_FALSE(ui_->find("Pressure"));
    under_cursor_->pressure = 12;
    settle();
    EXPECT_TRUE(ui_->find("Pressure"));
    scenario_.lower.emplace();
    scenario_.lower->material = "sand";
    under_cursor_->lower_share = 0.35;
    settle();
    EXPECT_TRUE(ui_->find("Mixture"));
}

TEST_F(UiHand, shows_notices_until_they_have_faded) {
    notices_.tell(Notice::Kind::kInfo, "Loaded a valley.", screen_.seconds());
    frame();
    EXPECT_TRUE(ui_->find("Loaded a valley."));
    screen_.pass(Notices::kInfoStays);
    frame();
    EXPECT_FALSE(ui_->find("Loaded a valley."));
}

TEST_F(UiHand, leaves_the_middle_of_the_picture_free_at_first) {
    under_cursor_.emplace();
    notices_.tell(Notice::Kind::kInfo, "Loaded a valley.", screen_.seconds());
    settle();
    for (int x = 256; x <= 1024; x += 128)
        for (int y = 144; y <= 540; y += 36) {
            screen_.move(x, y);
            frame();
            EXPECT_FALSE(ui_->keeps_mouse()) << x << " " << y;
        }
}

}  // namespace
}  // namespace game::test
