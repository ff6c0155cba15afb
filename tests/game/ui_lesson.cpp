#include <gtest/gtest.h>

#include "game/files/ui_font.h"
#include "game/words/words.h"
#include "tests/game/ui_hand.h"

namespace game::test {
namespace {

// The card of a stop, over a small world.
class UiLesson : public UiHand {
  protected:
    UiLesson() {
        stop_.heading = "In the run";
        stop_.text = "It has reached {speed}.";
        timeline_ = {.known_until = 100, .watches = true};
    }
    void open_card() {
        lesson_.emplace(ui::LessonNote{.title = "A trial", .stop = stop_, .figures = figures_, .stops = 3});
        settle(6);
    }
    void ask(std::size_t length) {
        stop_.question = Lesson::Question{};
        stop_.question->asks = std::string(length, '?');
        stop_.question->answers = {"One", "Two", std::string(80, 'x')};
        stop_.question->right = 1;
        stop_.question->why = "Because.";
    }
    Lesson::Stop stop_;
    LessonFigures figures_;
};

TEST_F(UiLesson, shows_no_card_between_stops) {
    settle();
    EXPECT_FALSE(ui_->find("Lesson"));
    open_card();
    EXPECT_TRUE(ui_->find("Lesson"));
    EXPECT_FALSE(only<LessonWish>(click("Go on")).answer);
}

TEST_F(UiLesson, asks_its_question_once_and_says_why) {
    ask(20);
    open_card();
    EXPECT_FALSE(ui_->find("Verdict"));
    EXPECT_EQ(only<LessonWish>(click("Two")).answer, 1u);
    lesson_->answer = 0;
    settle();
    EXPECT_TRUE(ui_->find("Verdict"));
    EXPECT_TRUE(click("Two").empty());
}

TEST_F(UiLesson, ends_with_a_new_start_a_world_to_play_in_or_a_look_around) {
    open_card();
    lesson_->number = 3;
    lesson_->tells_guess = true;
    settle();
    EXPECT_TRUE(ui_->find("Guess"));
    EXPECT_FALSE(ui_->find("Go on"));
    EXPECT_EQ(only<Verb>(click("Start again")), Verb::kReset);
    EXPECT_EQ(only<Verb>(click("Take over")), Verb::kTakeOver);
    EXPECT_FALSE(only<LessonWish>(click("Look around")).answer);
}

TEST_F(UiLesson, marks_the_guess_and_where_the_front_stopped) {
    EXPECT_FALSE(ui_->find("Your guess"));
    lesson_marks_ = {{{400, 300}, false}, {{500, 350}, true}};
    settle();
    EXPECT_TRUE(ui_->find("Your guess"));
    EXPECT_TRUE(ui_->find("Stopped here"));
}

TEST_F(UiLesson, keeps_clear_of_the_bars_and_keeps_its_buttons_however_long_its_text_is) {
    const auto font = ui_font();
    if (!font) GTEST_SKIP() << "there is no font";
    ask(200);
    for (int i = 0; i < 60; ++i) stop_.text += " A long word.";
    for (const double letters : {1.0, 2.0}) {
        display_.letters = letters;
        begin_anew({1280, 720, 1}, font);
        open_card();
        const auto card = place("Lesson"), bar = place("Time bar"), toolbar = place("Toolbar");
        EXPECT_GE(card.y, toolbar.y + toolbar.height) << letters;
        EXPECT_LE(card.y + card.height, bar.y) << letters;
        EXPECT_GE(card.x, 0);
        EXPECT_LE(card.x + card.width, 1280);
        const auto button = place("Go on");
        EXPECT_LE(button.y + button.height, card.y + card.height) << letters;
        EXPECT_TRUE(ui_->cut().empty());
        lesson_.reset();
    }
}

}  // namespace
}  // namespace game::test
