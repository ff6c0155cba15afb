#include <algorithm>

#include <gtest/gtest.h>

#include "game/recording/recording_file.h"
#include "render/pictures/png.h"
#include "tests/window/play_session.h"
#include "tests/window/screenshot.h"

// The sandbox tested with real input. The effect of a session is read from its recording, which must replay.
namespace game::test {
namespace {

class Play : public testing::Test {
  protected:
    void SetUp() override {
        if (const auto missing = missing_for_a_desktop()) GTEST_SKIP() << *missing;
        session.emplace();
    }

    XSession& hand() { return session->hand(); }

    // Holds the left button at the middle until the recording has that many commands of a kind.
    void hold_until(const std::string& kind, std::size_t count) {
        hand().press(Mouse::kLeft);
        EXPECT_TRUE(session->comes_to(kind, count)) << "no " << kind << " is recorded";
        hand().release(Mouse::kLeft);
    }

    std::optional<PlaySession> session;
};

double least(const std::vector<nlohmann::json>& commands, const char* number) {
    double value = 1e300;
    for (const auto& command : commands) value = std::min(value, command.at(number).get<double>());
    return value;
}

double most(const std::vector<nlohmann::json>& commands, const char* number) {
    double value = -1e300;
    for (const auto& command : commands) value = std::max(value, command.at(number).get<double>());
    return value;
}

TEST_F(Play, pours_where_the_button_is_held_and_dragged) {
    hand().press(Mouse::kLeft);
    ASSERT_TRUE(session->comes_to("pour", 10));
    const auto held = session->commands("pour");
    // The pointer does not move. As the heap rises, the ray meets the ground a little nearer to the camera.
    EXPECT_LT(most(held, "x") - least(held, "x"), 2) << "m";
    hand().drag(PlaySession::kMiddleX + 60, PlaySession::kMiddleY + 20);
    ASSERT_TRUE(session->comes_to("pour", held.size() + 10));
    hand().release(Mouse::kLeft);
    const auto poured = session->commands("pour");
    EXPECT_GT(most(poured, "x") - least(poured, "x"), 5) << "m";

    ASSERT_TRUE(session->runs());  // the release event has arrived
    const std::size_t after = session->commands();
    ASSERT_TRUE(session->runs(30));
    EXPECT_EQ(session->commands(), after) << "it pours without input";
    EXPECT_GT(session->last_state()["mass"]["poured"], 0);
    EXPECT_EQ(session->commands("pour").size(), after);
    session->leave();
}

TEST_F(Play, digs) {
    hand().key("2");
    hold_until("dig", 10);
    ASSERT_TRUE(session->runs());
    EXPECT_GT(session->last_state()["mass"]["dug"], 0);
    EXPECT_EQ(session->commands("dig").size(), session->commands());
    session->leave();
}

TEST_F(Play, blasts_at_the_press_and_again_along_a_drag) {
    hand().key("3");
    hand().press(Mouse::kLeft);
    ASSERT_TRUE(session->comes_to("blast", 1));
    ASSERT_TRUE(session->runs(30));
    EXPECT_EQ(session->commands("blast").size(), 1u) << "the pointer did not move";
    hand().drag(PlaySession::kMiddleX + 100, PlaySession::kMiddleY, 20);
    EXPECT_TRUE(session->comes_to("blast", 3));
    hand().release(Mouse::kLeft);
    EXPECT_EQ(session->commands("blast").size(), session->commands());
    session->leave();
}

TEST_F(Play, inverts_the_tools_while_control_is_held) {
    for (const auto& [tool, contrary] : {std::pair("1", "dig"), {"2", "pour"}, {"3", "settle"}}) {
        hand().key(tool);
        const std::size_t before = session->commands(), of_it = session->commands(contrary).size();
        hand().key_down("Control_L");
        hold_until(contrary, of_it + 1);
        hand().key_up("Control_L");
        ASSERT_TRUE(session->runs());
        EXPECT_EQ(session->commands() - before, session->commands(contrary).size() - of_it);
    }
    session->leave();
}

TEST_F(Play, sizes_the_brush_by_brackets_and_by_the_wheel_with_shift) {
    hold_until("pour", 1);
    ASSERT_TRUE(session->runs());
    const double usual = session->commands("pour").back()["radius"];
    const std::size_t count = session->commands("pour").size();
    for (int i = 0; i < 3; ++i) hand().key("bracketright");
    hold_until("pour", count + 1);
    ASSERT_TRUE(session->runs());
    const double larger = session->commands("pour").back()["radius"];
    EXPECT_GT(larger, usual);
    const std::size_t again = session->commands("pour").size();
    hand().key_down("Shift_L");
    hand().wheel(-2);
    hand().key_up("Shift_L");
    hold_until("pour", again + 1);
    ASSERT_TRUE(session->runs());
    const double smaller = session->commands("pour").back()["radius"];
    EXPECT_LT(smaller, larger);
    EXPECT_GT(smaller, usual) << "three steps up and two down";
    session->leave();
}

TEST_F(Play, pauses_and_steps_tick_by_tick) {
    hand().key("space");
    ASSERT_TRUE(within(5, [&] { return session->stands(); })) << "it is not paused";
    // To a tick whose state is in the file, so that the ticks after it can be counted.
    const std::int64_t paused = session->tick();
    for (int i = 0; i < 6 && session->tick() == paused; ++i) {
        hand().key("period");
        within(0.5, [&] { return session->tick() != paused; });
    }
    const std::int64_t from = session->tick();
    ASSERT_GT(from, paused);
    for (int i = 0; i < 3; ++i) {
        hand().key("period");
        rest(0.3);  // leaves a frame between any two, also on a slow machine
    }
    EXPECT_TRUE(session->stands());
    EXPECT_EQ(session->tick(), from);
    session->leave();
    EXPECT_EQ(session->lines().back()["end"], from + 3);
}

TEST_F(Play, continues_after_a_pause) {
    hand().key("space");
    ASSERT_TRUE(within(5, [&] { return session->stands(); })) << "it is not paused";
    hand().key("space");
    EXPECT_TRUE(session->runs());
    session->leave();
}

TEST_F(Play, undoes_the_last_action_in_the_world_and_in_the_file) {
    hold_until("pour", 10);
    ASSERT_TRUE(session->runs());
    const std::size_t first = session->commands("pour").size();
    hand().key("2");
    hold_until("dig", 10);
    ASSERT_TRUE(session->runs());
    hand().key("ctrl+z");
    EXPECT_TRUE(within(10, [&] { return session->commands("dig").empty(); })) << "the dig is still there";
    EXPECT_EQ(session->commands("pour").size(), first) << "only the last action is undone";
    hand().key("ctrl+z");
    EXPECT_TRUE(within(10, [&] { return session->commands() == 0; })) << "the pour is still there";
    ASSERT_TRUE(session->runs()) << "the simulation continues from there";
    EXPECT_EQ(session->last_state()["mass"]["poured"], 0);
    EXPECT_EQ(session->last_state()["mass"]["dug"], 0);
    session->leave();
}

TEST_F(Play, continues_through_resizing_and_minimising) {
    hand().resize(800, 560);
    EXPECT_TRUE(session->runs());
    const auto is_drawn = [&](int x, int y) {
        const render::Picture shown = hand().screenshot();
        const auto at = static_cast<std::size_t>(y * shown.width + x) * 3;
        return shown.pixels.at(at) + shown.pixels.at(at + 1) + shown.pixels.at(at + 2) > 0;
    };
    EXPECT_TRUE(within(10, [&] { return is_drawn(790, 550); })) << "nothing is drawn in the new corner";
    hand().minimise();
    rest(0.5);  // several frames while minimised
    hand().restore();
    EXPECT_TRUE(session->runs());
    hand().move(400, 280);
    hold_until("pour", 5);
    session->leave();
}

TEST_F(Play, ends_the_stroke_when_its_window_is_minimised) {
    hand().press(Mouse::kLeft);
    ASSERT_TRUE(session->comes_to("pour", 5));
    hand().minimise();
    hand().release(Mouse::kLeft);
    hand().restore();
    ASSERT_TRUE(session->runs());
    const std::size_t after = session->commands();
    ASSERT_TRUE(session->runs(30));
    EXPECT_EQ(session->commands(), after) << "it pours without input";
    session->leave();
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    if (std::filesystem::exists(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
    return files;
}

TEST_F(Play, takes_a_screenshot_of_the_world_while_a_panel_is_open) {
    const auto screenshots = hand().folder() / "couloir/screenshots";
    hand().key("F2");
    std::vector<std::filesystem::path> taken;
    for (const std::size_t count : {1, 2}) {  // one after the other: pressed twice within a frame it is one
        hand().key("F12");
        ASSERT_TRUE(within(20, [&] {
            taken = files_in(screenshots);
            return taken.size() == count && std::all_of(taken.begin(), taken.end(), [](const auto& file) {
                       return file.extension() == ".png" && render::read_png(file, 3);
                   });
        })) << taken.size();
    }
    for (const auto& file : taken) {
        const auto image = render::read_png(file, 3);
        EXPECT_EQ(image->width, PlaySession::kWidth);
        EXPECT_EQ(image->height, PlaySession::kHeight);
        EXPECT_EQ(file.filename().string().rfind("hands-", 0), 0u) << file;
        const std::string bytes = read_bytes(file);
        for (const auto& [keyword, text] :
             {std::pair<std::string, std::string>("Recording", "session.couloir"),
              {"Scene", "hands"},
              {"Camera", "target = [80"}})
            EXPECT_NE(bytes.find(keyword + '\0' + text), std::string::npos) << keyword;
    }
    session->leave();
}

TEST_F(Play, shares_the_slide_so_far_and_goes_on) {
    hold_until("pour", 20);
    ASSERT_TRUE(session->runs());
    const std::size_t poured = session->commands("pour").size();
    hand().key("F10");
    EXPECT_TRUE(session->runs(30)) << "the world stands still while its slide is shared";
    std::vector<std::filesystem::path> shared;
    ASSERT_TRUE(within(60, [&] { return !hand().opened().empty(); }));
    shared = files_in(hand().folder() / "couloir/shared");
    ASSERT_EQ(shared.size(), 1u);
    EXPECT_EQ(hand().opened(), shared[0].string() + "\n");
    EXPECT_EQ(shared[0].filename().string().rfind("hands-", 0), 0u) << shared[0];
    EXPECT_EQ(files_in(shared[0]).size(), 2u);
    EXPECT_GT(std::filesystem::file_size(shared[0] / "slide.html"), 10'000u);
    const auto recording = read_recording(shared[0] / "slide.couloir");
    ASSERT_TRUE(recording) << recording.error().sentence;
    EXPECT_EQ(recording->commands.size(), poured);
    const Finished replayed = couloir({"replay", (shared[0] / "slide.couloir").string(), "--verify"});
    EXPECT_EQ(replayed.status, 0) << replayed.err;
    EXPECT_NE(replayed.out.find("exact"), std::string::npos) << replayed.out << replayed.err;
    session->leave();
}

TEST_F(Play, leaves_nothing_of_a_shared_slide_if_it_quits_meanwhile) {
    hold_until("pour", 100);
    hand().key("F10");
    session->leave();
    for (const auto& folder : files_in(hand().folder() / "couloir/shared"))
        EXPECT_EQ(files_in(folder).size(), 2u) << "neither whole nor gone";
}

TEST_F(Play, closes_during_a_stroke) {
    hand().press(Mouse::kLeft);
    ASSERT_TRUE(session->comes_to("pour", 10));
    hand().close();
    session->check_ending();
}

TEST_F(Play, leaves_a_recording_that_replays_when_killed_during_a_stroke) {
    hand().press(Mouse::kLeft);
    ASSERT_TRUE(session->comes_to("pour", 30));
    hand().kill();
    EXPECT_EQ(hand().finish().status, 128 + 9);
    EXPECT_GT(session->commands(), 0u);
    session->check_replay();
}

// Needs no desktop.
TEST(PlayWithoutADisplay, prints_one_line_and_status_3) {
    const support::TemporaryFolder folder;
    const auto out = folder.path() / "out", err = folder.path() / "err";
    Child play({support::program().string(), "play"},
               {{"DISPLAY", std::nullopt},
                {"WAYLAND_DISPLAY", std::nullopt},
                {"XDG_DATA_HOME", folder.path().string()}},
               out, err);
    EXPECT_EQ(play.wait(20), 3);
    const std::string said = read_bytes(err);
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_NE(said.find("couloir replay"), std::string::npos) << said;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "couloir")) << "an empty recording is left behind";
}

}  // namespace
}  // namespace game::test
