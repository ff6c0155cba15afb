#include "game/share/beside_page.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/web/browser_test.h"
#include "tests/web/shared_slide.h"

// Two slides side by side in a browser: what is done to one is done to the other.
namespace game::test {
namespace {

constexpr std::int64_t kShort = 60, kLong = 120;  // ticks

const std::string& page_of_two() {
    static const std::string page = [] {
        PageOptions options;
        options.plays = false;
        const SharedSlide one = share_slide("snow-avalanche", kShort, "A </script><b>short</b> one", options),
                          other = share_slide("snow-avalanche", kLong, "A long one", options);
        return beside_page({{{one.scenario.title, one.page}, {other.scenario.title, other.page}}}).value();
    }();
    return page;
}

class BesidePage : public BrowserTest {
  protected:
    void SetUp() override {
        BrowserTest::SetUp();
        if (IsSkipped()) return;
        browser().size(640, 300);
        ASSERT_EQ(browser().open(file_of(page_of_two())), "ready");
        browser().value("for (const frame of frames) frame.contentWindow.couloir.freeze(0.1)");
    }
    static std::string of(int frame, const std::string& member) {
        return "frames[" + std::to_string(frame) + "].contentWindow.couloir." + member;
    }
    static bool agree(const std::string& member) {
        return browser().comes("JSON.stringify(" + of(0, member) + ") === JSON.stringify(" + of(1, member) +
                               ")");
    }
    static double tick(int frame) { return browser().value(of(frame, "tick")).get<double>(); }
};

TEST_F(BesidePage, shows_both_at_one_time_from_one_place_and_says_nothing_wrong) {
    EXPECT_TRUE(agree("tick"));
    EXPECT_TRUE(agree("shown"));
    EXPECT_EQ(browser().value("document.title"), "A </script><b>short</b> one | A long one");
    for (const std::string& message : browser().messages()) ADD_FAILURE() << message;
    EXPECT_TRUE(holds("frames.every(frame => frame.contentDocument.querySelector('b') === null)"));
    for (const std::string& request : browser().requests())
        EXPECT_EQ(request.find("http"), std::string::npos) << request;
}

TEST_F(BesidePage, follows_the_one_that_is_touched) {
    browser().click(480, 100);  // the right one leads
    browser().value(of(1, "seek(48)"));
    EXPECT_TRUE(browser().comes(of(0, "tick === 48")));
    const auto pose = browser().value("JSON.stringify(" + of(1, "shown.camera") + ")").get<std::string>();
    browser().drag(480, 150, 540, 150);
    EXPECT_TRUE(browser().comes("JSON.stringify(" + of(1, "shown.camera") + ") !== '" + pose + "'"));
    EXPECT_TRUE(agree("shown.camera"));
    browser().value(of(1, "choose(2)"));
    EXPECT_TRUE(agree("shown.overlay"));
    EXPECT_TRUE(holds(of(0, "shown.overlay !== null")));
    browser().click(160, 100);
    browser().value(of(0, "seek(12)"));
    EXPECT_TRUE(browser().comes(of(1, "tick === 12")));
}

TEST_F(BesidePage, lets_the_longer_slide_play_on_to_its_end) {
    browser().click(160, 100);
    browser().value(of(0, "seek(0)"));
    browser().value(of(0, "play(true)"));
    EXPECT_TRUE(browser().comes(of(1, "playing")));
    EXPECT_TRUE(browser().comes("!" + of(1, "playing"), 60));
    EXPECT_EQ(tick(0), kShort);
    EXPECT_EQ(tick(1), kLong);
    EXPECT_FALSE(holds(of(0, "playing")));
}

}  // namespace
}  // namespace game::test
