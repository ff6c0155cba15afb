#include <gtest/gtest.h>

#include "tests/game/ui_hand.h"

namespace game::test {
namespace {

using Best = Catalogue::Best;

// The menu over a small world.
class UiMenu : public UiHand {
  protected:
    UiMenu() {
        using Kind = Catalogue::Kind;
        catalogue_.scenes.insert(
            catalogue_.scenes.begin(),
            {{"bowl", "The bowl", "/scenes/bowl.toml", Kind::kChallenge, "", {}, "Empty 300 m3 of it.", 1},
             {"bowl-hard", "The small bowl", "/scenes/bowl-hard.toml", Kind::kChallenge, "bowl", {}, "", 2},
             {"dam", "The dam", "/scenes/dam.toml", Kind::kChallenge, "", {}, "Build it.", 3}});
        catalogue_.own_of(ShelfKind::kRecording) = {
            {"2026-11-21_18-04-59_valley", "/own/newest.couloir", "/own/newest.couloir"},
            {"mine", "/own/mine.couloir", "/own/mine.couloir"}};
    }
    void open_page(const char* page) {
        ui_->perform(Verb::kMenu);
        settle();
        EXPECT_TRUE(click(page).empty());
        settle();
    }
};

TEST_F(UiMenu, stands_over_the_panels_and_takes_every_click) {
    ui_->perform(Verb::kMenu);
    settle();
    EXPECT_TRUE(ui_->shows_menu());
    for (const char* under : {"Pour", "Pause", "Hint"}) EXPECT_FALSE(ui_->find(under)) << under;
    screen_.move(1270, 400);
    settle();
    EXPECT_TRUE(ui_->keeps_mouse());
    EXPECT_TRUE(click("Resume").empty());
    settle();
    EXPECT_FALSE(ui_->shows_menu());
    EXPECT_TRUE(ui_->find("Pour"));
}

TEST_F(UiMenu, continues_the_newest_recording_when_the_program_has_just_started) {
    ui_->begin_menu();
    settle();
    EXPECT_FALSE(ui_->find("Resume"));
    Open open = only<Open>(click("Continue"));
    EXPECT_EQ(open.name_or_path, "/own/newest.couloir");
    EXPECT_TRUE(open.goes_on);

    recording_ = "/own/newest.couloir";  // it is being written
    settle();
    EXPECT_EQ(only<Open>(click("Continue")).name_or_path, "/own/mine.couloir");

    catalogue_.own_of(ShelfKind::kRecording).clear();
    settle();
    EXPECT_FALSE(ui_->find("Continue"));
}

TEST_F(UiMenu, describes_a_challenge_at_the_first_click_and_starts_it_at_the_second) {
    open_page("Challenges");
    EXPECT_TRUE(click("The dam").empty());
    settle();
    EXPECT_TRUE(ui_->find("Difficulty"));
    EXPECT_FALSE(ui_->find("Your best"));
    EXPECT_EQ(only<Open>(click("Start")).name_or_path, "dam");
}

TEST_F(UiMenu, proposes_the_first_challenge_that_is_not_won) {
    catalogue_.scenes[0].best = Best{900, 2};
    open_page("Challenges");
    EXPECT_EQ(only<Open>(click("Start")).name_or_path, "dam");
}

TEST_F(UiMenu, opens_a_harder_challenge_with_gold_in_the_other_one) {
    open_page("Challenges");
    for (const auto& [bowl, small, opens] : {std::tuple(std::optional<Best>(), std::optional<Best>(), false),
                                             {Best{900, 2}, std::nullopt, false},
                                             {Best{1465, 3}, std::nullopt, true},
                                             {Best{900, 2}, Best{300, 1}, true}}) {
        catalogue_.scenes[0].best = bowl, catalogue_.scenes[1].best = small;
        settle();
        EXPECT_TRUE(click("The small bowl").empty());
        settle();
        EXPECT_EQ(click("Start").size(), opens ? 1u : 0u);
    }
}

TEST_F(UiMenu, opens_a_recording_by_its_file_because_scenes_have_names_too) {
    open_page("Watch");
    const auto choose = [&](const char* list, const char* item) {
        EXPECT_TRUE(click(list).empty());
        EXPECT_TRUE(click(item).empty());
        settle();
    };
    EXPECT_TRUE(click("A valley, 21 Nov 18:04").empty()) << "a card does not begin at the first touch";
    settle();
    const Open watched = only<Open>(click("Watch"));
    EXPECT_EQ(watched.name_or_path, "/own/newest.couloir");
    EXPECT_FALSE(watched.goes_on);
    EXPECT_TRUE(only<Open>(click("Continue at its end")).goes_on);
    choose("Shelf", "Slides that ship");
    EXPECT_TRUE(click("A slope that slid").empty());
    settle();
    EXPECT_EQ(only<Open>(click("Watch")).name_or_path, "/recordings/slope.couloir");
    EXPECT_FALSE(ui_->find("Rename"));
}

TEST_F(UiMenu, moves_no_button_when_a_picture_comes) {
    open_page("Watch");
    settle();
    const auto watch = *ui_->find("Watch"), order = *ui_->find("Order");
    EXPECT_GE(watch.y - (order.y + order.height), watch.width * 9 / 16)
        << "room for a picture that is still being read";
}

TEST_F(UiMenu, finds_and_sorts_what_the_user_has_made) {
    open_page("Watch");
    const auto is_left_of = [&](const char* one, const char* other) { return place(one).x < place(other).x; };
    EXPECT_TRUE(is_left_of("A valley, 21 Nov 18:04", "mine"));
    EXPECT_TRUE(click("Order").empty());
    EXPECT_TRUE(click("oldest first").empty());
    settle();
    EXPECT_TRUE(is_left_of("mine", "A valley, 21 Nov 18:04"));
    EXPECT_TRUE(click("Search").empty());
    screen_.type("MIN");
    settle();
    EXPECT_TRUE(ui_->find("mine"));
    EXPECT_FALSE(ui_->find("A valley, 21 Nov 18:04"));
}

TEST_F(UiMenu, renames_and_throws_away_only_once_it_was_asked_again) {
    open_page("Watch");
    EXPECT_TRUE(click("mine").empty());
    settle();
    EXPECT_TRUE(click("Rename").empty());
    settle();
    EXPECT_TRUE(click("Keep the name").empty());
    settle();
    EXPECT_TRUE(click("Rename").empty());
    settle();
    EXPECT_TRUE(click("New name").empty());
    screen_.tap(Key::kEnd);
    settle();
    screen_.type(" two, 2.5 m");
    settle();
    const auto renamed = only<RenameFile>(click("Rename it"));
    EXPECT_EQ(renamed.file, "/own/mine.couloir");
    EXPECT_EQ(renamed.name, "mine two, 2.5 m");
    settle();
    EXPECT_TRUE(click("mine").empty());
    settle();
    EXPECT_EQ(only<ShowFile>(click("Folder")).file, "/own/mine.couloir");
    EXPECT_TRUE(click("Throw away").empty());
    settle();
    EXPECT_TRUE(click("Keep it").empty());
    settle();
    EXPECT_TRUE(click("Throw away").empty());
    settle();
    EXPECT_EQ(only<ThrowAway>(click("To the trash")).file, "/own/mine.couloir");
}

TEST_F(UiMenu, goes_back_from_a_page_and_closes_for_a_panel) {
    open_page("Free play");
    EXPECT_TRUE(ui_->find("A slope"));
    ui_->perform(Verb::kClosePanel);
    settle();
    EXPECT_TRUE(ui_->shows_menu());
    EXPECT_FALSE(ui_->find("A slope"));
    ui_->perform(Verb::kToggleScene);
    settle();
    EXPECT_FALSE(ui_->shows_menu());
    EXPECT_EQ(only<Verb>(click("Other scenes")), Verb::kMenu);
}

TEST_F(UiMenu, gives_an_action_the_key_that_is_pressed) {
    open_page("Keys");
    const auto row_of = [&](std::string_view name) {
        std::size_t row = 0;
        while (keys_.name(row) != name) ++row;
        return row;
    };
    EXPECT_TRUE(click("key of dig").empty());
    EXPECT_EQ(ui_->keeps_keys(), KeysKept::kAll);
    screen_.tap(key('K'));
    const BindKey bound = only<BindKey>(frame());
    EXPECT_EQ(bound.row, row_of("dig"));
    EXPECT_EQ(bound.key, key('K'));
    keys_.bind(bound.row, {bound.key, bound.with});
    settle();
    EXPECT_EQ(ui_->keeps_keys(), KeysKept::kOfWorld);

    EXPECT_TRUE(click("key of dig").empty());
    screen_.tap(Key::kEscape);
    settle();
    EXPECT_FALSE(ui_->find("Conflict"));

    EXPECT_TRUE(click("key of dig").empty());
    screen_.tap(key('1'));  // is that of pouring
    settle();
    EXPECT_TRUE(ui_->find("Conflict"));
    EXPECT_TRUE(click("Leave it").empty());
    settle();
    EXPECT_FALSE(ui_->find("Conflict"));

    EXPECT_TRUE(click("key of dig").empty());
    screen_.tap(key('1'));
    settle();
    const Actions swapped = click("Swap");
    ASSERT_EQ(swapped.size(), 2u);
    for (const Action& action : swapped) {
        const auto& bind = std::get<BindKey>(action);
        keys_.bind(bind.row, {bind.key, bind.with});
    }
    EXPECT_EQ(keys_.at(row_of("dig")).key, key('1'));
    EXPECT_EQ(keys_.at(row_of("pour")).key, key('K'));
    settle();
    only<ResetKeys>(click("All usual keys"));
}

TEST_F(UiMenu, shows_what_each_part_of_a_gamepad_does) {
    open_page("Keys");
    EXPECT_TRUE(click("Gamepad").empty());
    settle();
    for (const PadPart& part : pad_parts()) EXPECT_TRUE(ui_->find(part.name)) << part.name;
    for (const PadBinding& binding : pad_bindings()) EXPECT_TRUE(ui_->find(binding.name)) << binding.name;
    ui_->perform(Verb::kClosePanel);
    settle();
    EXPECT_TRUE(ui_->find("All usual keys"));
}

TEST_F(UiMenu, has_every_page_on_a_small_screen_and_with_large_letters) {
    for (const ScreenSize size : {ScreenSize{1280, 720, 1}, {1280, 720, 2}, {800, 600, 1}, {2560, 1440, 2}}) {
        begin_anew(size);
        for (const char* page : {"Challenges", "Free play", "My hill", "Watch", "Settings", "Keys"}) {
            open_page(page);
            const auto at = place("Page of the menu");
            EXPECT_GE(at.width, size.width * 0.3) << page;
            EXPECT_LE(at.x + at.width, size.width) << page;
            EXPECT_TRUE(click("Back").empty());
            settle();
            const auto last = place("Quit");
            EXPECT_LE(last.y + last.height, size.height) << size.width;
            ui_->perform(Verb::kMenu);
            settle();
        }
    }
}

TEST_F(UiMenu, begins_a_lesson_from_its_card_in_free_play) {
    open_page("Free play");
    EXPECT_FALSE(ui_->find("A lesson"));
    catalogue_.lessons = {{"trial", "A lesson", "/lessons/trial.toml", Catalogue::Kind::kLesson}};
    settle();
    EXPECT_TRUE(click("A lesson").empty());
    settle();
    EXPECT_EQ(only<Open>(click("Start")).name_or_path, "/lessons/trial.toml");
}

}  // namespace
}  // namespace game::test
