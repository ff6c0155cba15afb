#include <string>

#include <gtest/gtest.h>

#include "game/controls/key_map.h"
#include "game/files/ui_font.h"
#include "game/words/plain.h"
#include "game/words/words.h"
#include "tests/game/ui_hand.h"

namespace game::test {
namespace {

// Everything that is shown, in every language, at both sizes of text.
class UiLanguages : public UiHand {
  protected:
    ~UiLanguages() override { speak(nullptr); }

    // One place after the other, until all were seen: each is opened, looked at, and left.
    void walk(const std::string& where) {
        const auto look = [&](const std::string& at) {
            settle();
            for (const std::string& words : ui_->cut())
                ADD_FAILURE() << where << at << ": no room for \"" << words << '"';
        };
        state_.params.density = 1800;  // with every tool
        for (const ToolInfo& info : tool_infos()) {
            brush_.tool = info.tool;
            look(std::string("tool ") + info.plain->label);
        }
        for (const Verb panel :
             {Verb::kToggleScene, Verb::kTogglePhysics, Verb::kToggleDisplay, Verb::kTogglePerformance,
              Verb::kToggleFilm, Verb::kToggleMeasure, Verb::kToggleHelp}) {
            ui_->perform(panel);
            look("panel " + std::to_string(static_cast<int>(panel)));
            ui_->perform(panel);
        }
        for (const std::optional<int> medal : {std::optional<int>(), std::optional(0), std::optional(3)}) {
            card_ = ui::ResultCard{"The bowl", "", "", "", medal, {}};
            look("result card");
            card_.reset();
        }
        Lesson::Stop stop;
        stop.heading = stop.text = "A text";
        stop.asks_guess = true;
        const LessonFigures figures;
        for (const std::size_t number : {1, 2}) {
            lesson_.emplace(ui::LessonNote{
                .title = "A lesson", .stop = stop, .figures = figures, .number = number, .stops = 2});
            lesson_->tells_guess = number == 2;
            look("card of a lesson");
        }
        lesson_.reset();
        for (const bool plainly : {true, false}) {
            speak_plainly(plainly);
            under_cursor_.emplace();
            under_cursor_->rolling = 1;
            under_cursor_->pressure = 12;
            under_cursor_->aspect_deg = 90;
            under_cursor_->water = 0.42;
            under_cursor_->thing.emplace();
            look("readings");
            under_cursor_.reset();
        }
        speak_plainly(false);
        const std::vector<CameraKey> keys{{1, {}}, {20, {}}};
        path_ = {keys, true, 1};
        ui_->perform(Verb::kToggleFilm);
        look("camera path");
        ui_->perform(Verb::kToggleFilm);
        path_ = {};
        photo_ = ui::PhotoNote{{}, focal_lengths(16.0 / 9), 14.5, {}};
        look("photo mode");
        photo_->taken = 0.5;
        look("photo mode, taking one");
        photo_.reset();
        timeline_ = {.known_until = 100, .watches = true};
        look("watching");
        timeline_ = {};
        for (const char* page : {"Challenges", "Free play", "My hill", "Watch", "Settings", "Keys"}) {
            ui_->perform(Verb::kMenu);
            settle();
            click(page);
            look(page);
            if (ui_->find("Gamepad")) {
                click("Gamepad");
                look("Gamepad");
            }
            ui_->close_menu();
        }
    }
};

TEST_F(UiLanguages, have_room_for_every_label_at_1280_by_720_and_at_twice_the_text_size) {
    const auto font = ui_font();
    if (!font) GTEST_SKIP() << "there is no font";
    catalogue_.own_of(ShelfKind::kRecording) = {
        {"2026-11-21_18-04-59_valley", "/own/newest.couloir", "/own/newest.couloir"}};
    languages_ = Languages::of_user();
    EXPECT_EQ(languages_.told().size(), 0u);
    ASSERT_GE(languages_.choices().size(), 2u);
    for (const LanguageChoice& language : languages_.choices())
        for (const double letters : {1.0, 2.0}) {
            languages_.choose(language.code);
            display_.letters = letters;
            begin_anew({1280, 720, 1}, font);
            walk(language.name + (letters > 1 ? ", twice the size, " : ", "));
        }
}

// Labels in the tests of this folder are English, whatever is shown.
TEST_F(UiLanguages, keep_the_places_of_widgets) {
    languages_ = Languages::of_user();
    languages_.choose("de");
    ASSERT_STREQ(tr("Pour"), "Schütten");
    begin_anew({1280, 720, 1});
    EXPECT_TRUE(ui_->find("Pour"));
    EXPECT_EQ(only<Tool>(click("Dig")), Tool::kDig);
}

TEST_F(UiLanguages, are_chosen_in_the_settings) {
    languages_ = Languages::of_user();
    begin_anew({1600, 1000, 1});
    ui_->perform(Verb::kToggleDisplay);
    settle();
    EXPECT_TRUE(ui_->find("Language"));
}

}  // namespace
}  // namespace game::test
