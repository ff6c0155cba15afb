#include <cmath>

#include <gtest/gtest.h>

#include "game/controls/key_map.h"
#include "game/ui/widgets.h"
#include "tests/game/ui_hand.h"

namespace game::test {
namespace {

struct PanelFacts {
    Verb verb;
    const char* button;
    std::vector<const char*> widgets;
};
const std::vector<PanelFacts> kPanels{
    {Verb::kToggleScene, "Scene", {"Close Scene", "Terrain", "Choose a scene", "Start", "Other scenes"}},
    {Verb::kTogglePhysics, "Physics", {"Close Physics", "start slope", "erosion rate"}},
    {Verb::kToggleDisplay,
     "Display",
     {"Close Display", "Colour by", "Contours", "Direction", "Text size", "Fly"}},
    {Verb::kTogglePerformance, "Performance", {"Close Performance", "Chart", "solve", "Worst tick"}},
    {Verb::kToggleFilm,
     "Film",
     {"Close Film", "Film camera", "Film size", "With sound", "Film it", "Add key", "Play the path",
      "Load path"}},
    {Verb::kToggleMeasure, "Measure", {"Close Measure", "Along a line", "Over time", "Draw a line"}},
    {Verb::kToggleHelp, "Help", {"Close Help", "step one tick"}},
};

class UiPanels : public UiHand {
  protected:
    void SetUp() override { begin_anew({1600, 1080, 1}); }

    // Slides to so many px beyond the slider's right end, asks for nothing on the way, and lets it go.
    Actions slide(const char* label, double px) {
        const auto at = place(label);
        screen_.move(at.x + at.width * 0.2, at.y + at.height / 2);
        frame();
        screen_.press(Button::kLeft);
        settle(2);
        screen_.move(at.x + at.width + px, at.y + at.height / 2);
        settle(2);
        screen_.release(Button::kLeft);
        return frame();
    }
};

TEST_F(UiPanels, open_and_close_by_their_verbs_with_all_that_is_in_them) {
    for (const PanelFacts& panel : kPanels) {
        const auto shown = [&] {
            int count = 0;
            for (const char* label : panel.widgets) count += ui_->find(label).has_value();
            return count;
        };
        EXPECT_EQ(shown(), 0) << panel.button;
        EXPECT_TRUE(ui_->perform(panel.verb));
        settle();
        EXPECT_EQ(shown(), static_cast<int>(panel.widgets.size())) << panel.button;
        EXPECT_TRUE(ui_->perform(panel.verb));
        settle();
        EXPECT_EQ(shown(), 0) << panel.button;
    }
}

TEST_F(UiPanels, open_by_their_buttons_and_close_by_their_crosses_without_asking_anybody) {
    for (const PanelFacts& panel : kPanels) {
        EXPECT_TRUE(click(panel.button).empty());
        EXPECT_TRUE(ui_->find(panel.widgets[0])) << panel.button;
        EXPECT_TRUE(click(panel.widgets[0]).empty());
        EXPECT_FALSE(ui_->find(panel.widgets[0])) << panel.button;
    }
}

TEST_F(UiPanels, ask_for_the_line_of_a_cross_section_and_show_it) {
    CrossSection section;
    section_.emplace(ui::SectionNote{.section = section});
    ui_->perform(Verb::kToggleMeasure);
    settle();
    EXPECT_FALSE(ui_->find("Profile"));
    EXPECT_TRUE(only<DrawSection>(click("Draw a line")).waits);
    section_->waits = true;
    settle();
    EXPECT_FALSE(only<DrawSection>(click("Draw no line")).waits);
    section_->waits = false;
    section.lay({{10, 10}, {10, 90}}, 0);
    section.see(sim::view(state_), {});
    settle();
    for (const char* label : {"Profile", "Speed along the line", "Of the line", "Scale of the layers"})
        EXPECT_TRUE(ui_->find(label)) << label;
    point_at("Profile");
    settle();
    EXPECT_TRUE(ui_->find("Of the line"));
}

TEST_F(UiPanels, show_plots_over_time_in_which_a_click_is_a_time) {
    state_.rolling(10, 5) = 1, state_.velocity_y(10, 5) = 10;
    SlideHistory history;
    Peaks peaks;
    const auto tick_s = static_cast<double>(state_.params.tick_s);
    for (state_.tick = 0; state_.tick < 1200; ++state_.tick)
        history.see(sim::view(state_), peaks, {}, tick_s, state_.tick);
    timeline_.known_until = state_.tick;
    history_ = &history;
    ui_->perform(Verb::kToggleMeasure);
    settle();
    EXPECT_TRUE(click("Over time").empty());
    settle();
    for (const char* label : {"Run-out so far", "Moving volume", "Largest speed", "Since"})
        EXPECT_TRUE(ui_->find(label)) << label;
    EXPECT_FALSE(ui_->find("Which house"));
    const Actions asked = click("Moving volume");
    ASSERT_FALSE(asked.empty());
    EXPECT_NEAR(static_cast<double>(std::get<SeekTick>(asked.front()).tick), 600, 12);
}

TEST_F(UiPanels, make_way_for_a_bar_in_the_photo_mode) {
    ui_->perform(Verb::kToggleScene);
    photo_ = ui::PhotoNote{{}, focal_lengths(1.6), 14.5, {1600, 1000, 1}};
    settle();
    for (const char* label : {"Start", "Pour", "Pause", "Hint"}) EXPECT_FALSE(ui_->find(label)) << label;
    ASSERT_TRUE(ui_->find("Photo bar"));
    EXPECT_LT(place("Photo bar").height, 80) << "slim";
    EXPECT_EQ(only<SetPhoto>(click("4 ×")).settings.times, 4);
    EXPECT_TRUE(click("1 ×").empty()) << "it is that already";
    EXPECT_EQ(only<Verb>(click("Take the photo")), Verb::kScreenshot);
    EXPECT_EQ(only<Verb>(click("Leave")), Verb::kPhoto);
    const auto set = [&](const char* label) {
        const Actions asked = click(label);  // in its middle
        EXPECT_FALSE(asked.empty()) << label;
        return asked.empty() ? PhotoSettings{} : std::get<SetPhoto>(asked.front()).settings;
    };
    EXPECT_NEAR(set("Focal length").focal_mm, std::sqrt(photo_->focal.least * photo_->focal.most), 2);
    EXPECT_EQ(set("Focal length").hour, std::nullopt) << "the light stays as it was until it is moved";
    EXPECT_NEAR(set("Time of day").hour.value_or(0), 12, 0.2);
    EXPECT_NEAR(set("Depth of field").f_number, 7, 1.5);
    photo_->settings.exposure = 2;
    EXPECT_EQ(set("Exposure").exposure, 0.0);
    photo_.reset();
    settle();
    for (const char* label : {"Start", "Pour", "Pause"}) EXPECT_TRUE(ui_->find(label)) << label;
}

TEST_F(UiPanels, take_only_the_verbs_that_are_theirs) {
    for (std::size_t i = 0; i < kVerbs; ++i) {
        const auto verb = static_cast<Verb>(i);
        EXPECT_EQ(ui_->perform(verb), verb >= Verb::kToggleScene && verb <= Verb::kTogglePanels) << i;
    }
}

TEST_F(UiPanels, hide_all_at_once_and_come_back_as_they_were) {
    ui_->perform(Verb::kToggleScene);
    settle();
    ui_->perform(Verb::kTogglePanels);
    settle();
    for (const char* label : {"Start", "Pour", "Pause", "Hint"}) EXPECT_FALSE(ui_->find(label)) << label;
    ui_->perform(Verb::kTogglePanels);
    settle();
    for (const char* label : {"Start", "Pour", "Pause", "Hint"}) EXPECT_TRUE(ui_->find(label)) << label;
}

TEST_F(UiPanels, close_one_by_one_from_the_top_a_list_before_its_panel) {
    ui_->perform(Verb::kToggleScene);
    ui_->perform(Verb::kToggleHelp);
    settle();
    const auto close = [&] {
        EXPECT_TRUE(ui_->perform(Verb::kClosePanel));
        settle();
    };
    close();
    EXPECT_FALSE(ui_->find("Close Help"));
    click("New material");
    settle();
    ASSERT_TRUE(ui_->find("dry sand"));  // an item of the list
    close();
    EXPECT_FALSE(ui_->find("dry sand"));
    EXPECT_TRUE(ui_->find("Close Scene"));
    close();
    EXPECT_FALSE(ui_->find("Close Scene"));
    close();  // nothing is left
    EXPECT_TRUE(ui_->shows_menu());
    EXPECT_FALSE(ui_->find("Pour"));
    close();
    EXPECT_FALSE(ui_->shows_menu());
}

TEST_F(UiPanels, tell_warnings_even_while_they_are_hidden) {
    ui_->perform(Verb::kTogglePanels);
    notices_.tell(Notice::Kind::kInfo, "All is well.", screen_.seconds());
    notices_.tell(Notice::Kind::kWarning, "The disk is full.", screen_.seconds());
    settle();
    EXPECT_TRUE(ui_->find("The disk is full."));
    EXPECT_FALSE(ui_->find("All is well."));
}

TEST_F(UiPanels, stand_one_at_a_time_where_there_is_room_for_one) {
    begin_anew({640, 360, 1});
    ui_->perform(Verb::kToggleScene);
    settle();
    EXPECT_TRUE(ui_->find("Close Scene"));
    ui_->perform(Verb::kTogglePhysics);
    settle();
    EXPECT_FALSE(ui_->find("Close Scene"));
    EXPECT_TRUE(ui_->find("Close Physics"));
}

TEST_F(UiPanels, keep_every_button_on_the_screen_at_any_size_and_scale) {
    for (const ScreenSize size :
         {ScreenSize{640, 360, 1}, {1280, 720, 1}, {1280, 720, 1.5}, {2560, 1440, 2}}) {
        begin_anew(size);
        for (const char* label :
             {"Pour", "Radius", "Strength", "Standing", "Help", "Pause", "Speed", "Reset"}) {
            const auto at = place(label);
            EXPECT_GE(at.x, 0) << label;
            EXPECT_GE(at.y, 0) << label;
            EXPECT_LE(at.x + at.width, size.width) << label << " at " << size.width;
            EXPECT_LE(at.y + at.height, size.height) << label << " at " << size.width;
        }
    }
}

TEST_F(UiPanels, show_all_of_the_performance_panel_in_the_usual_window) {
    ui_->perform(Verb::kTogglePerformance);
    for (const bool past : {false, true}) {
        timeline_.known_until = past ? 600 : 0;
        settle();
        EXPECT_TRUE(ui_->find("Close Performance"));
        const auto panel = place("Panel Performance"), last = place("Drawn by");
        EXPECT_LT(last.y + last.height, panel.y + panel.height) << past;
    }
}

TEST_F(UiPanels, keep_their_letters_while_minimised_and_take_those_of_the_size_after_it) {
    const double before = place("Pour").height;
    const auto show = [&](ScreenSize size) {
        screen_.resize(size);
        if (size.width > 0) return settle();
        for (int i = 0; i < 3; ++i) ui_->begin(screen_.poll(), screen_, display_.letters, 1.0 / 60);
    };
    show({0, 0, 1});
    show({1280, 720, 1});
    EXPECT_EQ(place("Pour").height, before);
    show({0, 0, 1});
    show({400, 300, 1});
    EXPECT_LT(place("Pour").height, before);
}

TEST_F(UiPanels, have_no_smaller_letters_on_a_monitor_below_96_dpi) {
    const double usual = place("Pour").height;
    for (const double scale : {0.5, 0.75, 1.25}) {
        begin_anew({1600, 1000, scale});
        EXPECT_EQ(place("Pour").height > usual, scale > 1) << scale;
        EXPECT_GE(place("Pour").height, usual) << scale;
    }
}

// Down to what nobody plays in.
TEST_F(UiPanels, keep_bars_readings_and_clock_apart_in_small_windows_and_with_large_letters) {
    under_cursor_.emplace();
    under_cursor_->forest.standing = 400;
    under_cursor_->pressure = 1;
    clock_.pause(true);
    for (const ScreenSize size : {ScreenSize{400, 300, 1}, {640, 480, 1}, {1280, 720, 2}, {320, 240, 1}}) {
        begin_anew(size);
        const auto tools = place("Tools"), time_bar = place("Time bar"), readings = place("Readings");
        EXPECT_LT(tools.y + tools.height, time_bar.y) << size.width;
        EXPECT_LE(tools.y + tools.height, readings.y) << size.width;
        EXPECT_LE(readings.y + readings.height, time_bar.y) << size.width;
        EXPECT_GT(readings.height, 2 * place("Height").height) << size.width;
        const auto clock = place("Time");
        if (const auto pace = ui_->find("paused")) {
            EXPECT_LE(clock.x + clock.width, pace->x) << size.width;
        }
        EXPECT_EQ(ui_->find("paused").has_value(), size.width >= 400) << size.width;
    }
}

TEST_F(UiPanels, begin_a_scene_as_it_was_chosen) {
    ui_->perform(Verb::kToggleScene);
    settle();
    Open open = only<Open>(click("Start"));
    EXPECT_EQ(open.name_or_path, "valley");  // what is loaded
    EXPECT_FALSE(open.overrides.material || open.overrides.model || open.overrides.squares ||
                 open.overrides.scheme);

    const auto choose = [&](const char* list, const char* item) {
        EXPECT_TRUE(click(list).empty());
        EXPECT_TRUE(click(item).empty());
    };
    choose("Choose a scene", "A slope");
    choose("New material", "dry sand");
    choose("New model", "bcre: no inertia");
    choose("New grid", "256 squares");
    open = only<Open>(click("Start"));
    EXPECT_EQ(open.name_or_path, "slope");
    EXPECT_EQ(open.overrides.material, "sand");
    EXPECT_EQ(open.overrides.model, sim::Model::kBcre);
    EXPECT_EQ(open.overrides.squares, 256);

    choose("New material", "scene default");
    EXPECT_FALSE(only<Open>(click("Start")).overrides.material);
}

TEST_F(UiPanels, play_the_best_runs_of_the_challenge_that_is_open) {
    ui_->perform(Verb::kToggleScene);
    settle();
    EXPECT_FALSE(ui_->find("Best runs"));
    best_runs_ = {{1465, 3, "2026-11-26 12:58:00", 1, "/best/first.couloir"},
                  {900, 0, "2026-11-25 08:00:59", 2, "/best/second.couloir"}};
    settle();
    EXPECT_TRUE(click("Best runs").empty());
    EXPECT_EQ(only<Open>(click("900, no medal, 2026-11-25 08:00")).name_or_path, "/best/second.couloir");
    EXPECT_TRUE(click("Best runs").empty());
    EXPECT_EQ(only<Open>(click("1465, gold, 2026-11-26 12:58")).name_or_path, "/best/first.couloir");
}

TEST_F(UiPanels, ask_for_a_film_as_it_was_chosen_and_stop_it) {
    ui_->perform(Verb::kToggleFilm);
    settle();
    EXPECT_EQ(only<FilmSlide>(click("Film it")).wish, FilmWish());
    const auto choose = [&](const char* list, const char* item) {
        EXPECT_TRUE(click(list).empty());
        EXPECT_TRUE(click(item).empty());
    };
    choose("Film camera", "follows the front");
    choose("Film size", "1920 × 1080");
    choose("Images per second", "60");
    choose("Kind of file", "WebM: for web pages");
    EXPECT_TRUE(click("With sound").empty());
    EXPECT_EQ(only<FilmSlide>(click("Film it")).wish,
              (FilmWish{FilmView::kChase, 1920, 1080, 60, FilmWish::Kind::kWebm, true}));
    filming_ = 0.25;
    settle();
    EXPECT_FALSE(ui_->find("Film it"));
    only<StopFilm>(click("Stop filming"));
}

TEST_F(UiPanels, make_a_camera_path_of_keys) {
    using What = EditPath::What;
    ui_->perform(Verb::kToggleFilm);
    settle();
    EXPECT_EQ(only<EditPath>(click("Add key")).what, What::kAdd);
    EXPECT_TRUE(click("Play the path").empty()) << "no key, no path";
    EXPECT_TRUE(click("Save path").empty());
    EXPECT_EQ(only<EditPath>(click("Load path")).what, What::kLoad);
    std::vector<CameraKey> keys;
    for (int i = 0; i < 12; ++i) keys.push_back({1.5 * i, {}});
    path_.keys = keys;
    settle();
    const EditPath go = only<EditPath>(click("3.0 s")), gone = only<EditPath>(click("##Remove key 2"));
    EXPECT_EQ(go.what, What::kGoTo);
    EXPECT_EQ(go.key, 2u);
    EXPECT_EQ(gone.what, What::kRemove);
    EXPECT_EQ(gone.key, 1u);
    EXPECT_TRUE(ui_->find("16.5 s"));
    EXPECT_EQ(only<EditPath>(click("Save path")).what, What::kSave);
    EXPECT_EQ(only<EditPath>(click("Play the path")).what, What::kPlay);
    path_.plays = true;
    settle();
    EXPECT_FALSE(ui_->find("Play the path"));
    EXPECT_EQ(only<EditPath>(click("Stop the preview")).what, What::kStop);
    EXPECT_TRUE(click("Film camera").empty());
    EXPECT_TRUE(click("along the camera path").empty());
    EXPECT_EQ(only<FilmSlide>(click("Film it")).wish.view, FilmView::kPath);
}

TEST_F(UiPanels, choose_whether_the_folder_of_a_shared_slide_is_opened) {
    ui_->perform(Verb::kToggleScene);
    settle();
    Display expected = display_;
    expected.shows_shared = false;
    EXPECT_EQ(only<SetDisplay>(click("Open shared")).display, expected);
}

TEST_F(UiPanels, hide_the_trees_of_a_scene_that_has_some) {
    ui_->perform(Verb::kToggleDisplay);
    settle();
    EXPECT_FALSE(ui_->find("Trees"));
    scenario_.trees.density = 100;
    settle();
    Display expected = display_;
    expected.trees = false;
    EXPECT_EQ(only<SetDisplay>(click("Trees")).display, expected);
}

TEST_F(UiPanels, change_one_thing_of_the_display_and_leave_the_rest) {
    ui_->perform(Verb::kToggleDisplay);
    settle();
    Display expected = display_;
    expected.contours = true;
    EXPECT_EQ(only<SetDisplay>(click("Contours")).display, expected);

    expected = display_;
    expected.labels = true;
    EXPECT_EQ(only<SetDisplay>(click("Labels")).display, expected);

    expected = display_;
    expected.flow_mesh = true;
    EXPECT_EQ(only<SetDisplay>(click("Fronts")).display, expected);

    EXPECT_TRUE(click("Colour by").empty());
    expected = display_;
    expected.overlay = render::Overlay::kSpeed;
    EXPECT_EQ(only<SetDisplay>(click("speed in plan")).display, expected);

    display_.light.azimuth_deg = 12;
    expected = display_;
    expected.light = scenario_.light;
    EXPECT_EQ(only<SetDisplay>(click("Reset sun")).display, expected);
    EXPECT_EQ(only<Verb>(click("Overview")), Verb::kOverview);
}

TEST_F(UiPanels, choose_the_quality_of_what_moves) {
    ui_->perform(Verb::kToggleDisplay);
    settle();
    Display expected = display_;
    expected.tier = Tier::kBalanced;
    EXPECT_EQ(only<SetDisplay>(click("Balanced")).display, expected);
    expected.tier = Tier::kFull;
    EXPECT_EQ(only<SetDisplay>(click("Full")).display, expected);
    EXPECT_TRUE(click("Fast").empty()) << "as it is";

    EXPECT_TRUE(click("Resolution limit").empty());
    expected = display_;
    expected.most_scale = 0.5;
    EXPECT_EQ(only<SetDisplay>(click("1/2")).display, expected);
    expected = display_;
    expected.frame_ms = 200;
    EXPECT_EQ(only<SetDisplay>(slide("Frame time", 50)).display, expected);
}

TEST_F(UiPanels, change_a_flow_while_it_runs_where_the_scene_shows_one) {
    ui_->perform(Verb::kToggleDisplay);
    settle();
    scenario_.flow.emplace();
    settle();
    EXPECT_TRUE(click("Texture cuts").empty());
    Display expected = display_;
    expected.flow.cut = false;
    EXPECT_EQ(only<SetDisplay>(click("no cuts")).display, expected);
    EXPECT_TRUE(click("Texture cuts").empty());
    expected = display_;
    expected.flow.source = sim::front::PointSource::kPaper;
    EXPECT_EQ(only<SetDisplay>(click("the paper's points")).display, expected);
}

TEST_F(UiPanels, size_letters_only_when_the_slider_is_let_go) {
    begin_anew({2400, 1400, 1});
    ui_->perform(Verb::kToggleDisplay);
    settle();
    const auto at = place("Text size");
    display_ = only<SetDisplay>(slide("Text size", -1)).display;
    EXPECT_EQ(display_.letters, 3);
    settle();
    EXPECT_GT(place("Pour").height, 2.5 * at.height);
}

TEST_F(UiPanels, offer_a_month_where_the_scene_has_a_date) {
    ui_->perform(Verb::kToggleDisplay);
    settle();
    EXPECT_FALSE(ui_->find("Month"));
    scenario_.look.date = display_.date = render::Date{7, 10};
    settle();
    Display expected = display_;
    expected.date = render::Date{8, 15};
    EXPECT_TRUE(click("Month").empty());
    EXPECT_EQ(only<SetDisplay>(click("August")).display, expected);
}

TEST_F(UiPanels, offer_no_letters_so_large_that_panels_lose_their_place) {
    begin_anew({1280, 720, 1});
    ui_->perform(Verb::kToggleDisplay);
    settle();
    display_ = only<SetDisplay>(slide("Text size", 50)).display;
    EXPECT_GT(display_.letters, 1.4);
    EXPECT_LT(display_.letters, 1.8);
    settle();
    EXPECT_TRUE(click("Colour by").empty());  // can be reached
    EXPECT_TRUE(ui_->find("slope"));
    EXPECT_TRUE(click("Close Display").empty());  // closes the list
    EXPECT_TRUE(click("Close Display").empty());
    EXPECT_FALSE(ui_->find("Close Display"));
}

TEST_F(UiPanels, list_every_key_and_every_gesture_in_the_help) {
    begin_anew({1280, 720, 1});
    ui_->perform(Verb::kToggleHelp);
    settle();
    const KeyMap map;
    for (const KeyBinding& binding : map.presses())
        EXPECT_TRUE(ui_->find(binding.meaning)) << binding.meaning;
    for (const HeldBinding& binding : map.holds()) EXPECT_TRUE(ui_->find(binding.meaning)) << binding.meaning;
    for (const GestureBinding& binding : gesture_bindings())
        EXPECT_TRUE(ui_->find(binding.meaning)) << binding.meaning;
}

TEST_F(UiPanels, keep_the_card_between_the_bars_with_all_of_its_buttons) {
    auto map = std::make_shared<ui::SlideMap>();
    map->width = 320, map->height = 240;
    map->north_east = {320, 240};
    card_ =
        ui::ResultCard{"The hill", "Lost", "The load is 5 kPa, and must be at most 4.9 kPa.", "", 0, {}, map};
    for (const ScreenSize size : {ScreenSize{1280, 720, 1}, {1600, 1000, 1}, {640, 360, 1}}) {
        for (const std::size_t rows : {4U, 8U}) {
            card_->rows.assign(rows, {"Greatest load on a house", "249 569 m³ (at most 300 000 m³)"});
            begin_anew(size);
            settle(10);
            const auto card = place("Result"), tools = place("Tools"), time_bar = place("Time bar");
            EXPECT_GE(card.y, tools.y + tools.height) << size.width << " " << rows;
            EXPECT_LE(card.y + card.height, time_bar.y) << size.width << " " << rows;
            EXPECT_TRUE(ui_->find("Look around") || size.width == 640) << size.width << " " << rows;
            EXPECT_TRUE(ui_->find("Map") || size.height < 1000) << rows;
        }
    }
}

TEST_F(UiPanels, write_volumes_in_one_way) {
    std::array<char, 64> text;
    EXPECT_STREQ(ui::write_with_volumes(text, "Bring 30,000 m3 down, or 150 m3."),
                 "Bring 30 000 m³ down, or 150 m³.");
    EXPECT_STREQ(ui::write_with_volumes(text, "1234567.5 m3 (at least 20000 m3)"),
                 "1 234 567.5 m³ (at least 20 000 m³)");
    EXPECT_STREQ(ui::write_with_volumes(text, "in 2,000 m"), "in 2,000 m");
    std::array<char, 8> little;
    EXPECT_STREQ(ui::write_with_volumes(little, "20,000 m3 of earth"), "20 000 ");
    EXPECT_STREQ(ui::write_number(text, "%.0f m", 1367), "1 367 m");
    EXPECT_STREQ(ui::write_number(text, "%.1f m", -123456.5), "-123 456.5 m");
    EXPECT_STREQ(ui::write_number(text, "%.0f m", -123), "-123 m");
}

TEST_F(UiPanels, tell_what_a_budget_of_digging_counts) {
    Goal goal;
    goal.say = "Plough at most 2,500 m3 away, so that the road is open at five again.";
    Goal::Tool dig;
    dig.kind = sim::CommandKind::kDig;
    dig.total = 2500;
    goal.tools = {dig};
    scenario_.goal = goal;
    goal_use_.emplace(*scenario_.goal);
    settle();
    EXPECT_TRUE(ui_->find("Dig: 2 500 m³ of 2 500 m³ left"));
    EXPECT_TRUE(ui_->find("What digging uses up"));
}

TEST_F(UiPanels, tell_what_is_left_of_a_budget_of_water) {
    state_.params.density = 1800;
    Goal goal;
    goal.say = "Let the slope go with at most 5,000 m3 of rain.";
    Goal::Tool wet;
    wet.kind = sim::CommandKind::kWet;
    wet.total = 5000;
    goal.tools = {wet};
    scenario_.goal = goal;
    goal_use_.emplace(*scenario_.goal);
    sim::Command rain = sim::usual_command(sim::CommandKind::kWet);
    rain.radius = 40, rain.rate = 0.1, rain.duration = 2;
    EXPECT_FALSE(goal_use_->take({0, rain}, scenario_.params.tick_s));
    settle();
    EXPECT_TRUE(ui_->find("Water: 3 995 m³ of 5 000 m³ left"));
    EXPECT_TRUE(ui_->find("Water"));
    EXPECT_FALSE(ui_->find("Pour"));
}

TEST_F(UiPanels, offer_a_cover_for_ground_on_which_nothing_lies) {
    EXPECT_FALSE(ui_->find("Cover it with 1 m"));
    const support::Ground ground = support::plane(20, 5, 0.6, 0);
    state_ = sim::make_state(ground.world(), scenario_.params);
    settle();
    EXPECT_FALSE(ui_->find("Hint"));
    EXPECT_EQ(only<CoverGround>(click("Cover it with 1 m")).depth, 1);
    state_.ledger.poured = state_.ledger.rolling = 1000;
    settle();
    EXPECT_FALSE(ui_->find("Cover it with 1 m"));
}

TEST_F(UiHand, goes_from_a_won_challenge_to_the_next_shipped_one) {
    catalogue_.scenes = {{"bowl", "The bowl", {}, Catalogue::Kind::kChallenge},
                         {"shovel", "The shovel", {}, Catalogue::Kind::kChallenge},
                         {"valley", "The valley", {}, Catalogue::Kind::kMountain}};
    card_ = ui::ResultCard{"The bowl", "Won: silver", "", "", 2, {}};
    scenario_.scene = "bowl";
    settle();
    EXPECT_EQ(only<Open>(click("Next")).name_or_path, "shovel");
    scenario_.scene = "shovel";
    settle();
    EXPECT_EQ(only<Open>(click("Next")).name_or_path, "bowl");
    EXPECT_EQ(only<Verb>(click("Try again")), Verb::kReset);
    only<ChallengeFriend>(click("Challenge a friend"));
    for (const std::optional<int> medal : {std::optional(0), std::optional<int>()}) {
        card_->medal = medal;
        settle();
        EXPECT_FALSE(ui_->find("Next"));
        EXPECT_FALSE(ui_->find("Challenge a friend")) << "there is nothing to beat";
        EXPECT_EQ(only<Verb>(click(medal ? "Try again" : "Again")), medal ? Verb::kReset : Verb::kUndo);
    }
    card_->medal = 3;
    scenario_.scene = "one of my own";
    settle();
    EXPECT_FALSE(ui_->find("Next"));
    EXPECT_EQ(only<Verb>(click("Look around")), Verb::kClosePanel);
}

TEST_F(UiHand, goes_from_gold_to_the_harder_challenge_and_from_there_to_the_next_one) {
    catalogue_.scenes = {{"bowl", "The bowl", {}, Catalogue::Kind::kChallenge},
                         {"bowl-hard", "The small bowl", {}, Catalogue::Kind::kChallenge, "bowl"},
                         {"shovel", "The shovel", {}, Catalogue::Kind::kChallenge}};
    card_ = ui::ResultCard{"The bowl", "Won: silver", "", "", 2, {}};
    scenario_.scene = "bowl";
    settle();
    EXPECT_EQ(only<Open>(click("Next")).name_or_path, "shovel");
    card_->medal = 3;
    settle();
    EXPECT_FALSE(ui_->find("Next"));
    EXPECT_EQ(only<Open>(click("Harder")).name_or_path, "bowl-hard");
    scenario_.scene = "bowl-hard";
    settle();
    EXPECT_EQ(only<Open>(click("Next")).name_or_path, "shovel");
}

}  // namespace
}  // namespace game::test
