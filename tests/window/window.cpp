#include <algorithm>
#include <array>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/controls/events.h"
#include "game/controls/keyboard.h"
#include "tests/window/screenshot.h"
#include "tests/window/x_session.h"

namespace game::test {
namespace {

const std::string kEcho = COULOIR_WINDOW_ECHO;

class Window : public testing::Test {
  protected:
    void SetUp() override {
        if (const auto missing = missing_for_a_desktop()) GTEST_SKIP() << *missing;
        desktop.emplace();
        desktop->start({kEcho}, "Echo");
    }

    // Whether it prints this line soon.
    bool says(const std::string& line) {
        const std::string whole = fmt::format("\n{}\n", line);
        return within(5, [&] { return desktop->out().find(whole) != std::string::npos; });
    }
    bool says(Key key, const std::string& options) {
        return says(fmt::format("key {} {}", static_cast<int>(key), options));
    }
    bool says_size(int width, int height, bool full_screen) {
        const std::string line = fmt::format("\nsize {} {} full screen {} ", width, height, full_screen);
        return within(5, [&] { return desktop->out().find(line) != std::string::npos; });
    }

    // Presses the keys; what it prints of keys that print something. Ends with F9, which prints nothing.
    std::string printing_keys(std::vector<std::string> keys) {
        const std::size_t before = desktop->out().size();
        keys.emplace_back("F9");
        desktop->keys(keys);
        const std::string end = fmt::format("key {} up", static_cast<int>(function_key(9)));
        EXPECT_TRUE(within(5, [&] { return desktop->out().find(end, before) != std::string::npos; }));
        std::istringstream lines(desktop->out().substr(before));
        std::string reported;
        for (std::string line, word, down, with; std::getline(lines, line);) {
            int number = 0;
            std::istringstream words(line);
            if (!(words >> word >> number >> down) || word != "key" || down != "down") continue;
            if (!KeyboardLayout::is_place(static_cast<Key>(number))) continue;
            if (words >> with) reported += with == "shift" ? "^" : with;
            reported += static_cast<char>(number);
        }
        return reported;
    }

    std::optional<XSession> desktop;
};

TEST_F(Window, has_the_size_that_was_asked_for_and_shows_what_is_drawn) {
    EXPECT_TRUE(says_size(640, 400, false)) << desktop->out();
    EXPECT_TRUE(within(5, [&] {
        const render::Picture shown = middle(desktop->screenshot(), 0.5);
        return shown.pixels[0] == 51 && shown.pixels[1] == 102 && shown.pixels[2] == 204;
    }));
}

TEST_F(Window, reports_moves_buttons_and_the_wheel) {
    desktop->move(100, 120);
    EXPECT_TRUE(says("move 100 120")) << desktop->out();
    desktop->press(Mouse::kLeft);
    EXPECT_TRUE(says("button 0 down")) << desktop->out();
    desktop->drag(140, 100, 2);
    EXPECT_TRUE(says("move 120 110")) << desktop->out();
    desktop->release(Mouse::kLeft);
    EXPECT_TRUE(says("button 0 up")) << desktop->out();
    desktop->press(Mouse::kRight);
    EXPECT_TRUE(says("button 1 down")) << desktop->out();
    desktop->release(Mouse::kRight);
    desktop->press(Mouse::kMiddle);
    EXPECT_TRUE(says("button 2 down")) << desktop->out();
    desktop->release(Mouse::kMiddle);
    desktop->wheel(1);
    EXPECT_TRUE(says("wheel 1")) << desktop->out();
    desktop->wheel(-1);
    EXPECT_TRUE(says("wheel -1")) << desktop->out();
}

TEST_F(Window, reports_keys_by_name_with_their_modifiers) {
    desktop->key("space");
    EXPECT_TRUE(says(Key::kSpace, "down") && says(Key::kSpace, "up")) << desktop->out();
    desktop->key("bracketleft");
    EXPECT_TRUE(says(Key::kLeftBracket, "down")) << desktop->out();
    desktop->key("period");
    EXPECT_TRUE(says(Key::kPeriod, "down")) << desktop->out();
    desktop->key("Home");
    EXPECT_TRUE(says(Key::kHome, "down")) << desktop->out();
    desktop->key("F5");
    EXPECT_TRUE(says(function_key(5), "down")) << desktop->out();
    desktop->key_down("Control_L");
    EXPECT_TRUE(says(Key::kControl, "down control")) << desktop->out();
    desktop->key("z");
    EXPECT_TRUE(says(key('Z'), "down control")) << desktop->out();
    desktop->key_up("Control_L");
    EXPECT_TRUE(says(Key::kControl, "up")) << "Control is still reported as held: " << desktop->out();
    desktop->key_down("Shift_L");
    desktop->wheel(1);
    EXPECT_TRUE(says("wheel 1 shift")) << desktop->out();
    desktop->key_up("Shift_L");
}

// Uses a layout that has both letters. For a letter that a layout lacks, xdotool remaps a key, and reverts it
// before a delayed program has looked it up.
TEST_F(Window, reports_typed_text) {
    desktop->keyboard("fr");
    desktop->type("7é");
    EXPECT_TRUE(says("text 55")) << desktop->out();
    EXPECT_TRUE(says("text 233")) << desktop->out();
}

// Each key as a keyboard types it, and what it is reported as: "^" if with Shift.
TEST_F(Window, takes_keys_as_what_they_print_on_each_layout) {
    const std::vector<std::string> marks{"bracketleft", "bracketright", "equal", "comma", "period"};
    struct Layout {
        const char* name;
        std::vector<std::string> more;
        std::string reported;
    };
    const std::array kLayouts{
        Layout{"us", {"minus", "8", "0", "z", "y", "shift+bracketleft"}, "-80ZY^["},
        Layout{"de", {"minus", "8", "0", "z", "y", "ssharp", "at", "udiaeresis", "Udiaeresis"}, "-80ZY[^["},
        Layout{"fr", {"parenright", "underscore", "8", "agrave", "z", "q", "m"}, "-880ZQM"},
        Layout{"ch", {"minus", "8", "0", "z", "y", "numbersign"}, "-80ZY"},
        Layout{"se", {"minus", "8", "0", "z", "y", "aring", "dollar"}, "-80ZY["},
    };
    for (const Layout& each : kLayouts) {
        desktop->keyboard(each.name);
        std::vector<std::string> keys = marks;
        keys.insert(keys.end(), each.more.begin(), each.more.end());
        EXPECT_EQ(printing_keys(keys), "[]=,." + each.reported) << each.name;
    }
}

TEST_F(Window, takes_letters_with_control_as_what_they_print) {
    desktop->keyboard("de");
    desktop->key("ctrl+z");
    EXPECT_TRUE(says(key('Z'), "down control")) << desktop->out();
}

TEST_F(Window, follows_its_size) {
    desktop->resize(900, 500);
    EXPECT_TRUE(says_size(900, 500, false)) << desktop->out();
    desktop->move(890, 490);
    EXPECT_TRUE(says("move 890 490")) << desktop->out();
}

TEST_F(Window, fills_the_screen_and_comes_back_to_its_old_place) {
    const XSession::Place before = desktop->place();
    desktop->key("F11");
    EXPECT_TRUE(says_size(1280, 800, true)) << desktop->out();
    desktop->key("F11");
    EXPECT_TRUE(within(5, [&] {
        const XSession::Place now = desktop->place();
        return now.x == before.x && now.y == before.y && now.width == 640 && now.height == 400;
    }));
}

TEST_F(Window, has_no_size_while_minimised_and_has_it_again) {
    desktop->minimise();
    EXPECT_TRUE(says_size(0, 0, false)) << desktop->out();
    EXPECT_TRUE(says("focus false")) << desktop->out();
    desktop->restore();
    EXPECT_TRUE(within(5, [&] {
        const std::string out = desktop->out();
        return out.find("size 640 400", out.find("size 0 0")) != std::string::npos;
    })) << desktop->out();
}

TEST_F(Window, lets_the_program_decide_to_close) {
    EXPECT_TRUE(says("clipboard névé")) << desktop->out();
    desktop->close();
    const Finished finished = desktop->finish();
    EXPECT_EQ(finished.status, 0);
    EXPECT_TRUE(says("close")) << finished.out;
}

// Needs no desktop.
TEST(NoWindow, prints_one_line_and_status_3_without_a_display) {
    const support::TemporaryFolder folder;
    for (const std::optional<std::string>& display :
         {std::optional<std::string>(), std::optional<std::string>(":9999")}) {
        const auto out = folder.path() / "out", err = folder.path() / "err";
        Child echo({kEcho}, {{"DISPLAY", display}, {"WAYLAND_DISPLAY", std::nullopt}}, out, err);
        EXPECT_EQ(echo.wait(20), 3);
        const std::string said = read_bytes(err);
        EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
        EXPECT_NE(said.find("no window: "), std::string::npos) << said;
        EXPECT_NE(said.find(display.value_or("no DISPLAY")), std::string::npos) << said;
    }
}

}  // namespace
}  // namespace game::test
