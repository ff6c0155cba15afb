#include <array>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/game/ui_hand.h"

namespace game::test {
namespace {

std::size_t index_of(std::string_view name) {
    for (std::size_t i = 0; i < std::size(sim::kParams); ++i)
        if (sim::kParams[i].name == name) return i;
    ADD_FAILURE() << name;
    return 0;
}

std::string label_of(const sim::ParamInfo& info) {
    std::string label(info.name == "tick_s" ? "tick" : info.name);
    for (char& c : label)
        if (c == '_') c = ' ';
    return label;
}

class UiPhysics : public UiHand {
  protected:
    void SetUp() override {
        begin_anew({1600, 1400, 1});  // all of the panel is to be seen
        ui_->perform(Verb::kTogglePhysics);
        settle();
    }
    bool refused() { return ui_->find("Refusal").has_value(); }
};

TEST_F(UiPhysics, shows_every_number_that_the_model_uses_and_no_other) {
    for (const sim::Model model : sim::kEveryModel) {
        scenario_.params.model = state_.params.model = model;
        settle();
        for (const sim::ParamInfo& info : sim::kParams)
            EXPECT_EQ(ui_->find(label_of(info)).has_value(), sim::is_used_by(info, model)) << info.name;
    }
}

TEST_F(UiPhysics, sets_a_number_that_was_typed) {
    const auto set = only<SetNumber>(type_into("drag", "275"));
    EXPECT_EQ(set.param, index_of("drag"));
    EXPECT_EQ(set.value, 275.f);
    EXPECT_FALSE(refused());
}

TEST_F(UiPhysics, takes_a_comma_and_blanks_as_people_write_them) {
    EXPECT_EQ(only<SetNumber>(type_into("drag", " 27,5 ")).value, 27.5f);
}

TEST_F(UiPhysics, reads_slopes_in_degrees) {
    const auto set = only<SetNumber>(type_into("start slope", "50"));
    EXPECT_EQ(set.param, index_of("start_slope"));
    EXPECT_FLOAT_EQ(set.value, 1.1917536f);  // tan 50°
}

TEST_F(UiPhysics, sets_nothing_before_the_number_is_whole) {
    EXPECT_TRUE(click("drag").empty());
    screen_.type("2");
    settle(2);
    screen_.type("5");
    settle(2);
    // A click elsewhere ends it as Enter does.
    EXPECT_EQ(only<SetNumber>(click("Time")).value, 25.f);
}

TEST_F(UiPhysics, sets_nothing_where_the_same_number_was_typed_or_the_edit_given_up) {
    state_.params.drag = scenario_.params.drag = 1500;
    frame();
    EXPECT_TRUE(type_into("drag", "1500.0").empty());
    EXPECT_TRUE(click("drag").empty());
    screen_.type("9");
    screen_.tap(Key::kEscape);
    settle();
}

TEST_F(UiPhysics, refuses_what_is_wrong_with_a_sentence_and_sets_nothing) {
    EXPECT_FALSE(refused());
    for (const char* nonsense : {"fast", "1.2.3", " ", "12 m", "nan", "1e99", "-1", "0"}) {
        EXPECT_TRUE(type_into("deposit speed", nonsense).empty()) << nonsense;
        EXPECT_TRUE(refused()) << nonsense;
        EXPECT_EQ(only<SetNumber>(type_into("drag", "27.5")).value, 27.5f);
        EXPECT_FALSE(refused());
    }
    EXPECT_TRUE(type_into("start slope", "90").empty());
    EXPECT_TRUE(refused());
}

TEST_F(UiPhysics, moves_no_row_for_what_it_refuses) {
    const ui::Ui::Place before = place("drag");
    EXPECT_TRUE(type_into("deposit speed", "fast").empty());
    settle();
    EXPECT_TRUE(refused());
    EXPECT_EQ(place("drag").y, before.y);
    EXPECT_EQ(place("drag").x, before.x);
}

TEST_F(UiPhysics, refuses_thresholds_in_the_wrong_order) {
    EXPECT_TRUE(type_into("friction", "1.9").empty());  // above that of a thin layer
    EXPECT_TRUE(refused());
}

TEST_F(UiPhysics, names_parameters_in_a_refusal_as_the_panel_does_and_tells_what_stays) {
    EXPECT_TRUE(type_into("friction", "1.9").empty());
    std::array<char, 80> told;
    std::snprintf(told.data(), told.size(), "Not set: friction is above friction thin. friction stays %.4g.",
                  static_cast<double>(state_.params.friction));
    EXPECT_TRUE(ui_->find(told.data())) << told.data();
}

TEST_F(UiPhysics, leads_back_to_a_default_to_the_bit) {
    EXPECT_FALSE(ui_->find("start slope: default"));
    const float usual = scenario_.params.start_slope;
    state_.params.start_slope = usual * 1.25f;
    frame();
    const auto set = only<SetNumber>(click("start slope: default"));
    EXPECT_EQ(set.param, index_of("start_slope"));
    EXPECT_EQ(set.value, usual);
}

TEST_F(UiPhysics, leads_back_to_all_defaults_in_an_order_in_which_each_step_holds) {
    EXPECT_TRUE(click("All defaults").empty());
    sim::Params& now = state_.params;
    now.friction = scenario_.params.friction * 0.5f;
    now.friction_thin = scenario_.params.friction * 0.6f;
    now.loose_slope = scenario_.params.friction * 0.7f;
    now.start_slope = scenario_.params.friction * 0.8f;  // below the default of what must lie below it
    now.drag = 700;
    ASSERT_FALSE(sim::fault_of(now)) << *sim::fault_of(now);
    frame();
    const Actions actions = click("All defaults");
    EXPECT_EQ(actions.size(), 5u);
    for (const Action& action : actions) {
        const auto& set = std::get<SetNumber>(action);
        now.*sim::kParams[set.param].value = set.value;
        EXPECT_FALSE(sim::fault_of(now)) << *sim::fault_of(now);
    }
    EXPECT_EQ(now, scenario_.params);
}

TEST_F(UiPhysics, lets_nobody_change_the_steps_of_the_computation) {
    EXPECT_TRUE(type_into("tick", "0.02").empty());
}

TEST_F(UiPhysics, keeps_the_keys_only_while_a_number_is_typed) {
    EXPECT_EQ(ui_->keeps_keys(), KeysKept::kNone);
    click("deposit speed");
    frame();
    EXPECT_EQ(ui_->keeps_keys(), KeysKept::kOfText);
    screen_.tap(Key::kEnter);
    settle();
    EXPECT_EQ(ui_->keeps_keys(), KeysKept::kNone);
}

TEST_F(UiPhysics, edits_as_text_fields_do) {
    constexpr Modifiers kControl{false, true, false};
    click("deposit speed");
    screen_.type("12");
    screen_.happen({KeyEvent{Key::kBackspace, true, false, {}}});
    screen_.type("7");  // after the key, though in the same frame
    screen_.happen({KeyEvent{Key::kBackspace, false, false, {}}});
    screen_.tap(key('A'), kControl);
    screen_.tap(key('C'), kControl);
    screen_.tap(Key::kEnter);
    Actions all;
    for (int i = 0; i < 12; ++i)
        for (const Action& action : frame()) all.push_back(action);
    EXPECT_EQ(only<SetNumber>(all).value, 17.f);
    EXPECT_EQ(screen_.clipboard(), "17");

    screen_.set_clipboard("23.5");
    click("deposit speed");
    screen_.tap(key('V'), kControl);
    screen_.tap(Key::kEnter);
    all.clear();
    for (int i = 0; i < 8; ++i)
        for (const Action& action : frame()) all.push_back(action);
    EXPECT_EQ(only<SetNumber>(all).value, 23.5f);
}

}  // namespace
}  // namespace game::test
