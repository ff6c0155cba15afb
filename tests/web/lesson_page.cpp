#include <string>

#include <gtest/gtest.h>

#include "game/session/loaded_world.h"
#include "game/share/share_recording.h"
#include "tests/game/program.h"
#include "tests/support/places.h"
#include "tests/web/browser_test.h"

// A lesson in a browser: the page halts at the stops of the window, with the same texts.
namespace game::test {
namespace {

constexpr const char* kHostileHeading = "</script><b onclick=x>Before</b>";

// The shipped lesson with a state each second, and with a heading that would be HTML.
const std::string& page_of_lesson() {
    static const std::string page = [] {
        LoadedWorld world = open_lesson("where-will-it-stop", {}).value();
        world.lesson->stops[0].heading = kHostileHeading;
        const support::TemporaryFolder folder;
        const auto file = folder.path() / "lesson.html";
        write_page_of_loaded(world, file, {.every = 60, .plays = false}).value();
        return read_bytes(file);
    }();
    return page;
}

class LessonPage : public BrowserTest {
  protected:
    static void open(int width, int height, bool touch = false) {
        browser().size(width, height, 1, touch);
        ASSERT_EQ(browser().open(file_of(page_of_lesson())), "ready");
        browser().value("couloir.freeze(0.1)");
    }
    static bool shows(const std::string& id) {
        return holds("document.getElementById('" + id + "').checkVisibility()");
    }
    static void click(const std::string& query) {
        browser().value("document.querySelector('" + query + "').click()");
    }
};

TEST(LessonPageText, has_figures_in_place_of_their_names) {
    const std::string& page = page_of_lesson();
    EXPECT_NE(page.find("It ran 1528 m in plan"), std::string::npos);
    EXPECT_EQ(page.find("{runout}"), std::string::npos);
    EXPECT_EQ(page.find(kHostileHeading), std::string::npos);
}

TEST_F(LessonPage, halts_at_each_stop_and_says_how_far_off_the_guess_was) {
    open(640, 400);
    ASSERT_TRUE(shows("lesson"));
    EXPECT_EQ(text("lesson-heading"), kHostileHeading) << "text, never HTML";
    EXPECT_EQ(text("lesson-place"), "Stop 1 of 4");
    EXPECT_EQ(text("title"), "Where will it stop?");
    EXPECT_TRUE(holds("couloir.tick === 0 && !couloir.playing"));
    click("#lesson-answers button:nth-child(1)");
    EXPECT_EQ(text("lesson-why").rfind("Not quite. ", 0), 0u);
    click("#lesson-answers button:nth-child(2)");
    EXPECT_EQ(text("lesson-why").rfind("Not quite. ", 0), 0u) << "the first answer counts";
    browser().value(
        "rate = document.getElementById('rate'), rate.value = 8, rate.dispatchEvent(new Event('change'))");
    click("#go-on");
    EXPECT_TRUE(browser().comes("couloir.tick === 300 && !couloir.playing"));
    EXPECT_EQ(text("lesson-heading"), "Crown and track");

    // Scrubbed meanwhile, it continues from its stop. A guess by keys alone.
    browser().press("g");
    EXPECT_EQ(text("lesson-guess").rfind("Your guess is marked", 0), 0u) << text("lesson-guess");
    EXPECT_TRUE(shows("pins"));
    browser().value("couloir.seek(120)");
    EXPECT_EQ(text("lesson-heading"), "Crown and track");
    browser().value("document.getElementById('view').focus()");
    browser().press(" ");
    EXPECT_TRUE(browser().comes("couloir.tick >= 300"));
    EXPECT_TRUE(browser().comes("couloir.tick === 2400 && !couloir.playing"));
    EXPECT_EQ(text("lesson-heading"), "In the run");
    click("#go-on");
    EXPECT_TRUE(browser().comes("couloir.tick === 3360 && !couloir.playing"));
    EXPECT_NE(text("lesson-guess").find(" m from where the front stopped."), std::string::npos);
    EXPECT_TRUE(shows("lesson-again"));
    click("#lesson-again");
    EXPECT_TRUE(holds("couloir.tick === 0"));
    EXPECT_EQ(text("lesson-heading"), kHostileHeading);
    EXPECT_EQ(text("lesson-why"), "");
    EXPECT_EQ(browser().messages(), std::vector<std::string>());
}

TEST_F(LessonPage, keeps_its_card_between_the_bars_of_large_and_small_screens) {
    open(390, 844, true);
    for (const auto& [width, height] : {std::pair(390, 844), std::pair(844, 390), std::pair(1280, 720)}) {
        SCOPED_TRACE(width);
        browser().size(width, height, 1, width != 1280);
        EXPECT_TRUE(browser().comes(R"((() => {
            const box = query => document.querySelector(query).getBoundingClientRect();
            const card = box('#lesson'), button = box('#go-on');
            return card.left >= 0 && card.top >= 0 && card.right <= innerWidth &&
                card.bottom <= box('footer').top && button.bottom <= card.bottom && button.height >= 36;
        })())",
                                    20));
    }
}

}  // namespace
}  // namespace game::test
