#include "game/app/app.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "game/analysis/headless.h"
#include "game/commands/runs_of_ensemble.h"
#include "game/ensemble/ensemble.h"
#include "game/files/assets.h"
#include "game/files/text_file.h"
#include "game/recording/format.h"
#include "game/recording/recording_file.h"
#include "game/scene/camera_keys.h"
#include "game/session/verifier.h"
#include "game/ui/scene_pictures.h"
#include "render/pictures/picture.h"
#include "render/pictures/png.h"
#include "tests/app/gl_screen.h"
#include "tests/support/allocations.h"
#include "tests/support/places.h"
#include "tests/support/slope_scene.h"

// The whole sandbox, from events to pixels and files, on a screen without a window.

namespace game {
namespace {

using app_test::GlScreen;

// Waits for another thread or program: two minutes at most, because the machine may have other work.
template <class Done>
void wait_until(Done done) {
    using Clock = std::chrono::steady_clock;
    for (const auto end = Clock::now() + std::chrono::minutes(2); !done() && Clock::now() < end;)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

class Playing : public testing::Test {
  protected:
    Playing() { setenv("XDG_DATA_HOME", folder_.path().c_str(), 1); }

    void begin(const std::string& what = "alpine-valley", int squares = 80) {
        if (squares > 0) wishes_.squares = squares;
        auto loaded = open_anything(what, wishes_);
        ASSERT_TRUE(loaded) << loaded.error().sentence;
        auto begun = App::begin(screen_, std::move(*loaded), sim::StepOptions{},
                                folder_.path() / "session.couloir", tier_, std::nullopt, settings_);
        ASSERT_TRUE(begun) << begun.error().sentence;
        app_ = std::move(*begun);
        frames(2);
    }

    void frames(int count) {
        for (int i = 0; i < count; ++i) ASSERT_TRUE(app_->frame());
    }

    // Lets time pass in a small window, because what takes long here is drawing.
    void pass(int count) {
        const ScreenSize before = screen_.size();
        screen_.resize_to(160, 90);
        frames(count);
        screen_.resize_to(before.width, before.height);
        frames(2);
    }

    void tap(Key key, Modifiers with = {}) {
        screen_.tap(key, with);
        frames(1);
    }

    // On the slope in the middle of the image, clear of panels.
    void point_at_slope() {
        screen_.move(kAtX, kAtY);
        frames(1);
    }

    void stroke(int count, Modifiers with = {}) {
        point_at_slope();
        screen_.press(Button::kLeft, with);
        frames(count);
        screen_.release(Button::kLeft);
        frames(1);
    }

    void blast_at(double x, double y) {
        screen_.move(x, y);
        frames(1);
        screen_.press(Button::kLeft);
        frames(2);
        screen_.release(Button::kLeft);
        frames(1);
    }

    bool shows(const char* label) const { return app_->panels().find(label).has_value(); }
    void click(const char* label) {
        const auto at = app_->panels().find(label);
        ASSERT_TRUE(at) << label;
        screen_.move(at->x + at->width / 2, at->y + at->height / 2);
        frames(2);
        screen_.press(Button::kLeft);
        frames(1);
        screen_.release(Button::kLeft);
        frames(2);
    }

    const sim::State& state() const { return app_->sandbox().session().state(); }
    const sim::Ledger& mass() const { return state().ledger; }
    StateLine line() const { return app_->sandbox().session().state_line(); }

    std::string last_notice() const {
        const Notices& notices = app_->notices();
        return notices.size() == 0 ? "" : notices[notices.size() - 1].sentence;
    }

    // Ends the session, replays its recording and compares the hash.
    void expect_recording_replays() {
        const StateLine live = line();
        ASSERT_TRUE(app_->finish());
        const auto recording = read_recording(*app_->recording());
        ASSERT_TRUE(recording) << recording.error().sentence;
        EXPECT_FALSE(recording->warning);
        EXPECT_EQ(recording->last_tick(), live.tick);
        auto session = Session::begin(recording->header.scenario, sim::StepOptions{}, std::nullopt);
        Verifier verifier(*recording);
        verifier.look_at(*session);
        std::size_t next = 0;
        std::vector<sim::Command> due;
        while (session->state().tick < recording->last_tick()) {
            due.clear();
            for (;
                 next < recording->commands.size() && recording->commands[next].tick == session->state().tick;
                 ++next)
                due.push_back(recording->commands[next].command);
            ASSERT_TRUE(session->advance(due));
            verifier.look_at(*session);
        }
        EXPECT_FALSE(verifier.verdict().parted) << *verifier.verdict().parted;
        EXPECT_EQ(verifier.verdict().proven_tick, live.tick);
        EXPECT_EQ(session->state_line(), live);
    }

    static constexpr double kAtX = 250, kAtY = 140;
    support::TemporaryFolder folder_;
    GlScreen screen_{640, 360};
    Overrides wishes_;
    std::optional<Tier> tier_ = Tier::kFast;
    SettingsFile settings_;  // of the next begin()
    std::unique_ptr<App> app_;
};

TEST_F(Playing, passes_time_slower_where_a_slide_breaks_loose_and_lets_the_camera_follow_it) {
    begin("alpine-valley", 0);
    tap(key('3'));
    stroke(1);
    frames(1);
    EXPECT_FALSE(sim::at_rest(state()));
    EXPECT_EQ(app_->clock().pace(), Pace::kAtRelease);
    const std::int64_t before = state().tick;
    frames(30);
    EXPECT_NEAR(static_cast<double>(state().tick - before), 15, 1);
    EXPECT_TRUE(app_->panels().find("slow: 0.5 ×"));
    screen_.resize_to(160, 90);
    frames(60);
    EXPECT_EQ(app_->clock().pace(), 1);
    tap(key('V'));
    frames(120);
    const render::Camera following = app_->camera();
    EXPECT_LT(following.distance_m, 500);
    frames(120);
    EXPECT_LT(app_->camera().target.z, following.target.z - 10);
}

TEST_F(Playing, lets_six_hours_of_weather_pass_in_a_second_and_two_in_a_storm) {
    const auto file = folder_.path() / "storm.toml";
    std::ofstream(file) << R"([terrain]
generator = "alpine-valley"
grid = 24
[cover]
material = "snow-dry"
[physics]
model = "bcre-inertial"
[weather]
days = 3
[[weather.storm]]
at = 6
hours = 3
precipitation = 6
wind_from = 290
wind_speed = 5
warmer = -10
)";
    begin(file.string(), 0);
    const auto& weather = state().weather;
    ASSERT_TRUE(weather);
    const auto hours_in = [&](int count) {
        const std::int64_t before = weather->hours;
        frames(count);
        return weather->hours - before;
    };
    while (weather->hours < 1) frames(1);
    EXPECT_NEAR(hours_in(50), 5, 1);
    EXPECT_NEAR(hours_in(90), 3, 1) << "a storm";
    EXPECT_NEAR(hours_in(60), 6, 1);
    EXPECT_EQ(state().ledger.rolling, 0);
    EXPECT_GT(state().ledger.fallen, 0);
    const auto same_hour = [&] {
        const std::int64_t before = weather->hours;
        stroke(20);
        return weather->hours - before;
    };
    EXPECT_LE(same_hour(), 1) << "what the hand does takes no time of the calendar";
    EXPECT_GT(mass().poured, 0);
    expect_recording_replays();
}

TEST_F(Playing, pours_by_holding_and_dragging_and_the_recording_replays_to_the_same_hash) {
    begin();
    point_at_slope();
    screen_.press(Button::kLeft);
    for (int i = 0; i < 30; ++i) {
        screen_.move(kAtX - i, kAtY);
        frames(1);
    }
    screen_.release(Button::kLeft);
    frames(20);
    EXPECT_GT(mass().poured, 0);
    EXPECT_EQ(app_->sandbox().actions(), 1u);
    expect_recording_replays();
}

TEST_F(Playing, says_of_the_mountains_around_that_brushes_do_nothing_there) {
    begin("snow-avalanche");
    bool told = false;
    for (double x = 10; x < 450 && !told; x += 8) {  // from the left, where the grid has ended
        screen_.move(x, 160);
        frames(1);
        screen_.press(Button::kLeft);
        frames(1);
        told = last_notice().find("scenery") != std::string::npos;
        screen_.release(Button::kLeft);
        frames(1);
    }
    EXPECT_TRUE(told) << last_notice();
    const auto poured = mass().poured;
    screen_.press(Button::kLeft);
    frames(10);
    screen_.release(Button::kLeft);
    frames(2);
    EXPECT_EQ(mass().poured, poured);
}

TEST_F(Playing, shows_what_the_hand_does_within_two_frames) {
    begin();
    tap(Key::kTab);  // hides the clock
    point_at_slope();
    frames(1000);  // until no notice is fading
    const auto before = screen_.picture().pixels;
    frames(2);
    ASSERT_EQ(screen_.picture().pixels, before) << "something else moves";
    screen_.press(Button::kLeft);
    frames(2);
    EXPECT_GT(mass().poured, 0);
    EXPECT_NE(screen_.picture().pixels, before);
}

TEST_F(Playing, allocates_nothing_in_a_frame_once_it_has_played_for_a_while) {
    screen_.resize_to(1280, 720);  // room for more than one panel
    begin();
    const KeyMap map;
    for (const Verb verb : {Verb::kToggleScene, Verb::kTogglePhysics, Verb::kToggleDisplay,
                            Verb::kTogglePerformance, Verb::kToggleMeasure})
        for (const KeyBinding& binding : map.presses())
            if (binding.does == std::variant<Verb, Tool>(verb)) tap(binding.key, binding.with);
    screen_.move(640, 330);
    frames(1);
    screen_.press(Button::kLeft);
    frames(80);
    ASSERT_GT(mass().poured, 0);
    // Pouring, recording, four panels open: the usual work of a frame.
    int without = 0;
    for (int i = 0; i < 60; ++i) {
        screen_.move(640 + i % 7, 330);
        const std::int64_t before = support::allocations();
        const std::size_t keyframes = app_->sandbox().keyframes().count();
        ASSERT_TRUE(app_->frame());
        if (app_->sandbox().keyframes().count() != keyframes) continue;  // a keyframe was stored
        ++without;
        ASSERT_EQ(support::allocations() - before, 0) << i;
    }
    EXPECT_GT(without, 30);
}

// A slide among forest, houses, nets, a road and a dam, with a tool in hand that shows what is left of the budget.
TEST_F(Playing, allocates_nothing_in_a_frame_among_things_once_it_has_played_for_a_while) {
    screen_.resize_to(1280, 720);
    begin("protection", 0);
    tap(key('4'));
    tap(key('N'));
    screen_.move(640, 420);
    frames(200);
    ASSERT_TRUE(app_->display().labels);
    EXPECT_TRUE(app_->panels().find("Front"));
    ASSERT_GT(mass().rolling, 0);
    ASSERT_GE(state().things->budget, 0);
    int quiet = 0, without = 0;
    for (int i = 0; i < 60; ++i) {
        screen_.move(640 + i % 7, 420);
        const std::size_t keyframes = app_->sandbox().keyframes().count();
        const std::int64_t changed = state().things->changed, before = support::allocations();
        ASSERT_TRUE(app_->frame());
        const std::int64_t allocated = support::allocations() - before;
        // A keyframe was stored, or something broke.
        if (app_->sandbox().keyframes().count() != keyframes || state().things->changed != changed) continue;
        ++quiet;
        without += allocated == 0;
    }
    EXPECT_GT(quiet, 30);
    EXPECT_GE(5 * without, 4 * quiet) << "a list of rectangles may grow with the flow, now and then";
}

// The pixels of a part of the image where there is neither a panel nor the ring.
std::vector<std::uint8_t> part_of(const render::Picture& picture) {
    std::vector<std::uint8_t> part;
    for (int y = 80; y < 130; ++y) {
        const auto row = picture.pixels.begin() + 3 * (y * picture.width + 200);
        part.insert(part.end(), row, row + 3 * 260);
    }
    return part;
}

TEST_F(Playing, finishes_an_image_that_stands_still_until_something_moves_in_every_tier) {
    for (const Tier tier : {Tier::kFast, Tier::kBalanced, Tier::kFull}) {
        tier_ = tier;
        begin();
        tap(Key::kSpace);
        screen_.move(300, 250);
        frames(2);
        const auto moving = part_of(screen_.picture());
        frames(40);
        const auto whole = part_of(screen_.picture());
        EXPECT_EQ(app_->image().size(), (ImageSize{640, 360, true}));
        EXPECT_EQ(whole == moving, tier == Tier::kFull);
        frames(5);
        EXPECT_EQ(part_of(screen_.picture()), whole);
        const auto with_ring = screen_.picture().pixels;
        screen_.move(310, 250);  // the ring follows, on the finished image
        frames(1);
        EXPECT_EQ(app_->image().size(), (ImageSize{640, 360, true}));
        EXPECT_NE(screen_.picture().pixels, with_ring);
        EXPECT_EQ(part_of(screen_.picture()), whole);
        screen_.press(Button::kRight);  // the camera turns
        frames(1);
        screen_.move(330, 250);
        frames(1);
        EXPECT_EQ(app_->image().size().fine, tier == Tier::kFull);
        app_.reset();
    }
}

TEST_F(Playing, shades_less_of_the_ground_while_the_camera_moves_and_no_longer) {
    tier_ = Tier::kFast;
    begin();
    frames(40);
    screen_.press(Button::kRight);
    frames(1);
    for (int i = 1; i < 5; ++i) {
        screen_.move(300 + 5 * i, 250);
        frames(1);
        EXPECT_TRUE(app_->image().size().moving) << i;
    }
    screen_.release(Button::kRight);
    frames(120);  // it glides to rest
    EXPECT_EQ(app_->image().size(), (ImageSize{640, 360, true}));
}

TEST_F(Playing, does_not_finish_an_image_while_a_slide_goes_on) {
    begin();
    stroke(20);
    screen_.move(5, 5);
    for (int i = 0; i < 60; ++i) {
        frames(1);
        ASSERT_FALSE(app_->image().size().fine) << i;
    }
}

// The clock of the screen stands still while a frame is drawn: nothing could be faster.
TEST_F(Playing, measures_in_its_first_frames_which_tier_suits_the_machine) {
    tier_.reset();
    begin();
    EXPECT_EQ(app_->image().size(), (ImageSize{320, 180, false})) << "its first images are small";
    frames(8);
    EXPECT_EQ(app_->display().tier, Tier::kFull);
    EXPECT_NE(last_notice().find("Quality: full"), std::string::npos) << last_notice();
}

TEST_F(Playing, draws_windows_of_any_size_while_it_runs) {
    begin();
    for (const auto& [width, height] :
         {std::pair{1, 1}, {1, 300}, {640, 360}, {3, 2}, {2600, 1}, {801, 433}}) {
        screen_.resize_to(width, height);
        frames(40);
        const render::Picture shown = screen_.picture();
        EXPECT_EQ(shown.width, width);
        const bool black =
            std::all_of(shown.pixels.begin(), shown.pixels.end(), [](int v) { return v < 60; });
        EXPECT_FALSE(black && width > 100 && height > 100) << width << " " << height;
    }
    expect_recording_replays();
}

TEST_F(Playing, stretches_a_smaller_image_over_a_window_that_is_larger_than_the_device_draws) {
    screen_.limit_side(500);
    begin();
    tap(Key::kSpace);
    frames(40);
    EXPECT_EQ(app_->image().size(), (ImageSize{500, 281, false}));
    EXPECT_NE(last_notice().find("500×281"), std::string::npos) << last_notice();
    const std::size_t told = app_->notices().size();
    frames(40);
    EXPECT_EQ(app_->notices().size(), told) << "once";
    screen_.resize_to(800, 200);
    frames(40);
    EXPECT_EQ(app_->image().size(), (ImageSize{500, 125, false}));
}

TEST_F(Playing, draws_a_smaller_image_in_the_same_frame_if_the_driver_has_no_memory) {
    tier_ = Tier::kFull;
    begin();
    frames(40);
    ASSERT_EQ(app_->image().size(), (ImageSize{640, 360, true}));
    screen_.move(300, 250);
    screen_.fail({DeviceFault::kOutOfMemory});
    frames(1);
    EXPECT_EQ(app_->image().size(), (ImageSize{640, 360, false}));
    EXPECT_EQ(app_->display().tier, Tier::kBalanced);
    EXPECT_NE(last_notice().find("no memory"), std::string::npos) << last_notice();
    screen_.move(310, 250);
    screen_.fail({DeviceFault::kRefused, DeviceFault::kOutOfMemory});
    frames(1);
    EXPECT_EQ(app_->display().tier, Tier::kFast);
    EXPECT_LT(app_->image().size().width, 640);
    frames(40);
    EXPECT_FALSE(app_->image().failure());
    EXPECT_LT(app_->image().size().width, 640) << "it stays so, also when it stands still";
}

TEST_F(Playing, ends_with_a_sentence_and_a_whole_recording_if_the_driver_draws_nothing) {
    for (const DeviceFault fault : {DeviceFault::kOutOfMemory, DeviceFault::kRefused, DeviceFault::kLost}) {
        begin();
        stroke(5);
        const int shown = screen_.frames();
        screen_.move(300, 250);
        screen_.fail(std::vector(20, fault));
        EXPECT_FALSE(app_->frame());
        EXPECT_EQ(screen_.frames(), shown) << "nothing wrong is shown";
        ASSERT_TRUE(app_->image().failure());
        EXPECT_EQ(app_->image().failure()->status, Failure::kMachine);
        expect_recording_replays();
        screen_.fail({});
        app_.reset();
    }
}

TEST_F(Playing, notices_a_lost_device_while_nothing_moves) {
    begin();
    tap(Key::kSpace);
    frames(60);
    screen_.fail({DeviceFault::kLost});
    EXPECT_FALSE(app_->frame());
    EXPECT_TRUE(app_->image().failure());
}

TEST_F(Playing, digs_and_blasts_and_inverts_both_with_control) {
    begin();
    tap(key('2'));
    stroke(10);
    EXPECT_GT(mass().dug, 0);
    EXPECT_EQ(mass().poured, 0);
    stroke(10, {.control = true});
    EXPECT_GT(mass().poured, 0);
    tap(key('3'));
    const auto rolling = mass().rolling;
    stroke(1);
    EXPECT_GT(mass().rolling, rolling);
    expect_recording_replays();
}

TEST_F(Playing, deposits_the_flow_with_an_inverted_blast) {
    begin();
    stroke(20);
    ASSERT_GT(mass().rolling, 0);
    tap(key('3'));
    for (int i = 0; i < 8; ++i) tap(Key::kRightBracket);  // larger than the poured heap
    const auto before = mass().rolling;
    stroke(1, {.control = true});
    EXPECT_LT(mass().rolling, before / 2);
    EXPECT_NE(last_notice().find("Loaded"), std::string::npos) << "nothing was refused";
    expect_recording_replays();
}

TEST_F(Playing, sculpts_plants_and_builds_and_takes_it_back) {
    begin();
    const auto things = [&]() -> const std::optional<sim::Things>& { return state().things; };
    tap(key('4'));
    stroke(12);
    ASSERT_TRUE(things());
    const auto raised = sim::earth_used(*things());
    EXPECT_GT(raised, 0);
    stroke(4, {.control = true});
    EXPECT_LT(sim::earth_used(*things()), raised);
    tap(key('7'));
    stroke(3);
    EXPECT_FALSE(things()->wooded.empty());
    stroke(3, {.control = true});
    EXPECT_TRUE(things()->wooded.empty());

    tap(key('8'));
    point_at_slope();
    screen_.press(Button::kLeft);
    frames(2);
    ASSERT_EQ(things()->list.size(), 1u);
    const double turn = things()->list[0].turn();
    screen_.move(kAtX + 60, kAtY);
    frames(3);
    screen_.release(Button::kLeft);
    frames(2);
    EXPECT_NE(things()->list[0].turn(), turn) << last_notice();
    stroke(2);
    EXPECT_EQ(things()->list.size(), 1u);
    EXPECT_NE(last_notice().find("stands on the house"), std::string::npos) << last_notice();
    stroke(2, {.control = true});
    EXPECT_TRUE(things()->list.empty());
    tap(key('Z'), {.control = true});
    EXPECT_EQ(things()->list.size(), 1u);
    expect_recording_replays();
}

TEST_F(Playing, builds_in_a_pause_with_one_tick_for_each_thing) {
    begin();
    tap(Key::kSpace);
    const auto paused = state().tick;
    tap(key('8'));
    stroke(6);
    ASSERT_TRUE(state().things);
    EXPECT_EQ(state().things->list.size(), 1u);
    EXPECT_EQ(state().tick, paused + 1);
    stroke(6);  // one stands there already: refused, in a tick of its own
    EXPECT_EQ(state().tick, paused + 2);
    stroke(6, {.control = true});
    EXPECT_TRUE(state().things->list.empty());
    EXPECT_EQ(state().tick, paused + 3);
    tap(key('7'));
    stroke(6);
    EXPECT_FALSE(state().things->wooded.empty());
    EXPECT_EQ(state().tick, paused + 4);
    stroke(6, {.control = true});
    EXPECT_TRUE(state().things->wooded.empty());
    EXPECT_EQ(state().tick, paused + 5);
    tap(key('R'));
    point_at_slope();
    screen_.press(Button::kLeft);
    frames(2);
    EXPECT_EQ(state().tick, paused + 5);
    screen_.move(kAtX + 30, kAtY);
    frames(2);
    screen_.release(Button::kLeft);
    frames(3);
    EXPECT_FALSE(state().things->list.empty());
    const auto after = state().tick;
    EXPECT_GT(after, paused + 5);
    frames(20);
    EXPECT_EQ(state().tick, after);
    EXPECT_TRUE(app_->clock().paused());
    tap(key('Z'), {.control = true});
    EXPECT_TRUE(state().things->list.empty());
    EXPECT_EQ(state().tick, paused + 5);
    expect_recording_replays();
}

TEST_F(Playing, lets_time_run_in_a_pause_while_the_brush_is_held) {
    begin();
    tap(Key::kSpace);
    const auto ticks_of = [&](int count) {
        const auto before = state().tick;
        stroke(count);
        const auto ticks = static_cast<double>(state().tick - before);
        frames(20);
        EXPECT_EQ(static_cast<double>(state().tick - before), ticks) << "paused again";
        return ticks;
    };
    tap(key('4'));
    EXPECT_NEAR(ticks_of(1), 1, 1);  // a click
    const auto raised = sim::earth_used(state().things.value());
    EXPECT_GT(raised, 0);
    EXPECT_NEAR(ticks_of(30), 30, 2);
    EXPECT_GT(sim::earth_used(*state().things), 10 * raised);
    tap(key('1'));
    EXPECT_NEAR(ticks_of(30), 30, 2);
    EXPECT_GT(mass().poured, 0);
    EXPECT_TRUE(app_->clock().paused());
    screen_.move(5, 5);  // no ground under the cursor
    frames(1);
    const auto before = state().tick;
    screen_.press(Button::kLeft);
    frames(10);
    screen_.release(Button::kLeft);
    frames(3);
    EXPECT_EQ(state().tick, before);
    expect_recording_replays();
}

TEST_F(Playing, blasts_in_a_pause) {
    begin();
    tap(Key::kSpace);
    tap(key('3'));
    const auto tick = state().tick;
    stroke(6);
    EXPECT_GT(mass().rolling, 0);
    EXPECT_EQ(state().tick, tick + 1);
    expect_recording_replays();
}

TEST_F(Playing, stands_still_once_paused_though_the_brush_is_held) {
    begin();
    point_at_slope();
    screen_.press(Button::kLeft);
    frames(10);
    tap(Key::kSpace);
    frames(3);
    const auto paused = state().tick;
    frames(10);
    EXPECT_EQ(state().tick, paused);
    screen_.release(Button::kLeft);
    frames(3);
    EXPECT_EQ(state().tick, paused);
}

TEST_F(Playing, draws_a_road_to_where_the_button_was_released) {
    begin();
    tap(key('R'));
    point_at_slope();
    screen_.press(Button::kLeft);
    frames(1);
    for (int i = 1; i <= 10; ++i) {
        screen_.move(kAtX + 12 * i, kAtY);
        frames(1);
    }
    screen_.release(Button::kLeft);
    screen_.move(kAtX, kAtY + 60);  // in the same frame
    frames(3);
    const auto& list = state().things.value().list;
    ASSERT_FALSE(list.empty());
    EXPECT_GT(list.size(), 1u);
    for (std::size_t i = 0; i < list.size(); ++i) {
        EXPECT_EQ(list[i].kind, sim::ThingKind::kRoad);
        if (i > 0) {
            EXPECT_EQ(list[i].x, list[i - 1].to_x);
        }
    }
    const double length = std::hypot(list.back().to_x - list.front().x, list.back().to_y - list.front().y);
    EXPECT_GT(length, 50);
    EXPECT_EQ(app_->sandbox().actions(), 1u);
    tap(key('Z'), {.control = true});
    EXPECT_TRUE(!state().things || state().things->list.empty());
    expect_recording_replays();
}

TEST_F(Playing, undoes_bit_identically_and_continues) {
    begin();
    stroke(10);
    tap(Key::kSpace);
    frames(3);
    const StateLine before = line();
    tap(Key::kSpace);
    stroke(25);
    frames(20);
    ASSERT_EQ(app_->sandbox().actions(), 2u);
    tap(Key::kSpace);  // so that no tick follows the undo immediately
    tap(key('Z'), {.control = true});
    EXPECT_EQ(app_->sandbox().actions(), 1u);
    // To just before the stroke: ticks between the pause and its first command remain.
    const StateLine after = line();
    EXPECT_LE(after.tick - before.tick, 4);
    EXPECT_EQ(after.ledger.poured, before.ledger.poured);
    auto again =
        Sandbox::begin(open_anything("alpine-valley", wishes_).value(), sim::StepOptions{}, std::nullopt);
    const Recording recording = read_recording(*app_->recording()).value();
    for (std::size_t next = 0; again->session().state().tick < after.tick;) {
        std::vector<sim::Command> due;
        for (; next < recording.commands.size() &&
               recording.commands[next].tick == again->session().state().tick;
             ++next)
            due.push_back(recording.commands[next].command);
        ASSERT_TRUE(again->tick(due));
    }
    EXPECT_EQ(again->session().state_line(), after);  // bit-identical
    EXPECT_NE(last_notice().find("Undone: pour"), std::string::npos) << last_notice();
    tap(Key::kSpace);
    frames(10);
    expect_recording_replays();
}

TEST_F(Playing, ctrl_y_and_ctrl_shift_z_redo_what_was_undone) {
    begin();
    frames(5);
    stroke(15);
    frames(5);
    stroke(15);
    frames(5);
    tap(Key::kSpace);
    const StateLine after = line();
    tap(key('Z'), {.control = true});
    tap(key('Z'), {.control = true});
    ASSERT_EQ(app_->sandbox().actions(), 0u);
    tap(key('Y'), {.control = true});
    tap(key('Z'), {.shift = true, .control = true});
    EXPECT_NE(last_notice().find("Redone: pour"), std::string::npos) << last_notice();
    frames(10);  // the world gets there within the time of a frame each
    EXPECT_EQ(app_->sandbox().actions(), 2u);
    EXPECT_EQ(line(), after);
    EXPECT_FALSE(app_->sandbox().looks_back());
    tap(key('Y'), {.control = true});
    EXPECT_EQ(last_notice(), "Nothing to redo");
    tap(Key::kSpace);
    frames(10);
    expect_recording_replays();
}

TEST_F(Playing, pauses_steps_and_changes_speed_without_changing_the_tick) {
    begin();
    tap(Key::kSpace);
    const auto paused = state().tick;
    frames(30);
    EXPECT_EQ(state().tick, paused);
    for (int i = 0; i < 3; ++i) tap(Key::kPeriod);
    EXPECT_EQ(state().tick, paused + 3);
    tap(Key::kSpace);
    tap(Key::kEqual);
    tap(Key::kEqual);
    const auto before = state().tick;
    frames(60);
    EXPECT_NEAR(static_cast<double>(state().tick - before), 240, 4);
    EXPECT_EQ(app_->clock().speed(), 4);
    expect_recording_replays();
}

TEST_F(Playing, turns_pans_zooms_and_flies_without_touching_the_world) {
    begin();
    tap(Key::kSpace);
    const StateLine before = line();
    render::Camera seen = app_->camera();
    const auto expect_another_view = [&](const char* after) {
        frames(40);
        EXPECT_FALSE(app_->camera() == seen) << after;
        seen = app_->camera();
    };
    for (const auto& [button, what] : {std::pair{Button::kRight, "turn"}, {Button::kMiddle, "pan"}}) {
        point_at_slope();
        screen_.press(button);
        frames(1);
        screen_.move(kAtX - 80, kAtY - 20);
        frames(1);
        screen_.release(button);
        expect_another_view(what);
    }
    screen_.happen({WheelEvent{3, {}}});
    expect_another_view("zoom");
    tap(key('T'));
    expect_another_view("top-down");
    tap(key('T'));
    expect_another_view("and back");
    screen_.happen({KeyEvent{key('W'), true, false, {}}});
    frames(20);
    screen_.happen({KeyEvent{key('W'), false, false, {}}});
    expect_another_view("walk");
    tap(Key::kHome);
    expect_another_view("overview");
    EXPECT_EQ(line(), before);
    EXPECT_EQ(app_->sandbox().actions(), 0u);
}

TEST_F(Playing, sizes_the_brush_by_brackets_and_by_wheel_with_shift) {
    begin();
    point_at_slope();
    const double before = app_->brush().radius;
    tap(Key::kRightBracket);
    EXPECT_GT(app_->brush().radius, before);
    tap(Key::kLeftBracket);
    EXPECT_NEAR(app_->brush().radius, before, 1e-9);
    screen_.happen({WheelEvent{-2, {.shift = true}}});
    frames(1);
    EXPECT_LT(app_->brush().radius, before);
}

TEST_F(Playing, restarts_with_the_same_first_hash_and_another_file) {
    begin();
    tap(Key::kSpace);
    tap(key('R'), {.control = true});
    const auto fresh = line().hash;  // paused at tick 0
    tap(Key::kSpace);
    stroke(20);
    tap(Key::kSpace);
    const auto first = app_->recording();
    tap(key('R'), {.control = true});
    EXPECT_EQ(state().tick, 0);
    EXPECT_EQ(line().hash, fresh);
    EXPECT_EQ(mass().poured, 0);
    EXPECT_NE(app_->recording(), first);
    EXPECT_FALSE(read_recording(*first).value().warning);  // closed
    tap(Key::kSpace);
    stroke(3);
    expect_recording_replays();
}

TEST_F(Playing, survives_being_minimised_and_resized_while_running) {
    begin();
    screen_.resize_to(0, 0);
    const int shown = screen_.frames();
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(app_->frame());
    EXPECT_EQ(screen_.frames(), shown);
    screen_.resize_to(801, 433);
    frames(3);
    EXPECT_EQ(screen_.picture().width, 801);
    stroke(5);
    expect_recording_replays();
}

TEST_F(Playing, closes_the_file_when_it_quits_during_a_stroke) {
    begin();
    point_at_slope();
    screen_.press(Button::kLeft);
    frames(10);
    screen_.happen({CloseEvent{}});
    EXPECT_FALSE(app_->frame());
    EXPECT_GT(mass().poured, 0);
    expect_recording_replays();
}

// A scripted screen has no sound device.
TEST_F(Playing, switches_sound_off_and_on_by_key_and_panel_without_changing_the_world) {
    begin();
    EXPECT_FALSE(app_->display().volumes.muted);
    tap(key('M'));
    EXPECT_TRUE(app_->display().volumes.muted);
    EXPECT_EQ(last_notice(), "Sound off");
    tap(key('M'));
    EXPECT_FALSE(app_->display().volumes.muted);
    screen_.resize_to(1280, 1600);  // all of the panel
    tap(function_key(4));
    frames(2);
    click("Sound");
    EXPECT_TRUE(app_->display().volumes.muted);
    expect_recording_replays();
}

TEST_F(Playing, rewinds_at_once_through_time_in_which_all_lay_still) {
    begin();
    pass(240);
    ASSERT_GT(state().tick, 200);
    tap(Key::kBackspace);
    frames(4);
    EXPECT_LE(state().tick, app_->sandbox().session().changed_at() + 1);
    EXPECT_LT(state().tick, 10);
}

TEST_F(Playing, begins_as_it_was_left) {
    setenv("XDG_CONFIG_HOME", folder_.path().c_str(), 1);
    settings_ = SettingsFile::of_user();
    begin();
    tap(key('M'));
    ASSERT_TRUE(app_->finish());
    app_.reset();
    settings_ = SettingsFile::of_user();
    begin();
    EXPECT_TRUE(app_->display().volumes.muted);
    ASSERT_TRUE(write_text(folder_.path() / "couloir/settings.toml", "version = 2"));
    app_.reset();
    settings_ = SettingsFile::of_user();
    begin();
    EXPECT_FALSE(app_->display().volumes.muted);
    const Notices& notices = app_->notices();
    EXPECT_TRUE(notices[0].sentence.ends_with("and changes are not kept")) << notices[0].sentence;
}

TEST_F(Playing, releases_all_keys_and_buttons_when_the_focus_is_lost) {
    begin();
    point_at_slope();
    screen_.press(Button::kLeft);
    frames(5);
    screen_.happen({FocusEvent{false}});
    frames(2);
    const auto poured = mass().poured;
    frames(10);
    EXPECT_EQ(mass().poured, poured);
}

TEST_F(Playing, opens_dropped_files_and_reports_errors) {
    begin();
    const auto before = line().hash;
    screen_.drop({folder_.path() / "none.toml"});
    frames(1);
    EXPECT_NE(last_notice().find("none.toml"), std::string::npos) << last_notice();
    EXPECT_EQ(app_->sandbox().scenario().scene, "alpine-valley");
    screen_.drop({support::source_dir() / "assets/scenes/landslide.toml"});
    frames(1);
    EXPECT_EQ(app_->sandbox().scenario().scene, "landslide");
    EXPECT_NE(line().hash, before);
    EXPECT_NE(screen_.title().find("slope of soil"), std::string::npos);
}

// As an elevation file has none; old snow is drawn on it all the same.
TEST_F(Playing, tells_that_nothing_lies_on_bare_ground_and_covers_it_if_asked) {
    screen_.resize_to(1280, 720);
    const auto file = folder_.path() / "hill.asc";
    {
        std::ofstream out(file);
        out << "ncols 41\nnrows 41\nxllcorner 0\nyllcorner 0\ncellsize 5\n";
        for (int y = 0; y < 41; ++y)
            for (int x = 0; x < 41; ++x) out << 1000 - 4 * y << (x < 40 ? ' ' : '\n');
    }
    begin(file.string(), 40);
    ASSERT_TRUE(mass().standing == 0 && shows("Cover it with 1 m"));
    tap(key('3'));
    blast_at(640, 330);
    EXPECT_EQ(last_notice(), "Nothing lies here that could be released");
    tap(key('2'));
    blast_at(640, 330);
    EXPECT_EQ(last_notice(), "Nothing lies here that could be dug away");
    tap(key('3'));
    screen_.happen({WheelEvent{5, {}}});
    pass(60);
    const render::Camera near = app_->camera();
    click("Cover it with 1 m");
    EXPECT_GT(mass().standing, 0);
    EXPECT_FALSE(shows("Cover it with 1 m"));
    EXPECT_LT(glm::distance(app_->camera().target, near.target), 0.1) << "and the blast is still in the hand";
    blast_at(640, 330);
    frames(20);
    EXPECT_NE(last_notice(), "Nothing lies here that could be released");
    EXPECT_FALSE(sim::at_rest(state()));
    expect_recording_replays();
}

TEST_F(Playing, watches_a_recording_hands_off_and_then_takes_over) {
    begin("landslide.couloir", 0);
    point_at_slope();
    screen_.press(Button::kLeft);
    frames(3);
    screen_.release(Button::kLeft);
    frames(1);
    EXPECT_NE(last_notice().find("Read-only"), std::string::npos) << last_notice();
    ASSERT_TRUE(app_->sandbox().watches());
    EXPECT_FALSE(app_->recording());
    const auto until = app_->sandbox().known_until();
    for (int i = 0; i < 4; ++i) tap(Key::kEqual);
    while (app_->sandbox().watches()) frames(1);
    EXPECT_NE(last_notice().find("bit for bit"), std::string::npos) << last_notice();
    EXPECT_GE(state().tick, until);
    tap(key('0'));
    const auto poured = mass().poured;
    stroke(5);
    EXPECT_GT(mass().poured, poured);
    expect_recording_replays();
}

// --record of a watched recording is written from the moment it is taken over, whatever else happens.
TEST_F(Playing, leaves_a_whole_file_of_a_watched_recording_however_it_is_left) {
    const auto file = folder_.path() / "session.couloir";
    struct Way {
        const char* name;
        std::vector<char> keys;  // E: Enter, R: Ctrl+R
        bool is_written_at_end;  // else what is open at the end is another one, in which nothing was done
    };
    for (const Way& way :
         {Way{"quit", {}, true}, Way{"restart", {'R'}, true}, Way{"take over", {'E'}, true},
          Way{"take over, restart", {'E', 'R'}, false}, Way{"restart, take over", {'R', 'E'}, true},
          Way{"take over, restart, take over", {'E', 'R', 'E'}, false}}) {
        std::filesystem::remove(file);
        begin("landslide.couloir", 0);
        frames(3);
        for (const char key : way.keys) {
            if (key == 'E') tap(Key::kEnter);
            if (key == 'R') tap(game::key('R'), {.control = true});
            frames(2);
        }
        ASSERT_TRUE(app_->finish()) << way.name;
        EXPECT_FALSE(app_->recording_failure()) << way.name;
        EXPECT_EQ(app_->recording().has_value(), way.is_written_at_end) << way.name;
        const auto recording = read_recording(file);
        ASSERT_TRUE(recording) << way.name << ": " << recording.error().sentence;
        EXPECT_FALSE(recording->warning) << way.name;
        app_.reset();
    }
}

TEST_F(Playing, goes_back_and_forth_and_takes_over_its_own_past) {
    begin();
    stroke(20);
    frames(30);
    const StateLine present = line();
    const auto first = *app_->recording();
    tap(Key::kComma);
    EXPECT_EQ(state().tick, present.tick - 1);
    EXPECT_TRUE(app_->clock().paused());
    stroke(3);
    EXPECT_NE(last_notice().find("Read-only"), std::string::npos) << last_notice();
    tap(Key::kPeriod);
    EXPECT_EQ(line(), present) << "back to the unchanged present";

    tap(Key::kBackspace);
    frames(20);
    EXPECT_LT(state().tick, present.tick - 10);
    EXPECT_EQ(app_->sandbox().known_until(), present.tick);
    tap(Key::kBackspace);
    const auto then = state().tick;
    EXPECT_EQ(*app_->recording(), first);
    tap(Key::kEnter);
    EXPECT_NE(last_notice().find("Branched at"), std::string::npos) << last_notice();
    EXPECT_NE(*app_->recording(), first);
    EXPECT_NEAR(static_cast<double>(app_->sandbox().known_until()), static_cast<double>(then), 3);
    stroke(10);
    expect_recording_replays();
    EXPECT_EQ(read_recording(first).value().last_tick(), present.tick) << "the abandoned part is kept";
}

TEST_F(Playing, makes_a_camera_path_that_is_played_saved_and_loaded_and_touches_nothing) {
    begin("landslide.couloir", 0);
    tap(Key::kSpace);
    const auto widen = [this] {
        screen_.resize_to(1000, 700);
        frames(2);
    };
    widen();
    tap(function_key(6));
    frames(2);
    click("Add key");
    tap(Key::kSpace);
    pass(60);
    tap(Key::kSpace);
    screen_.move(650, 400);
    screen_.happen({WheelEvent{5, {}}});
    pass(60);
    click("Add key");
    const std::vector<CameraKey> keys = app_->path().keys();
    ASSERT_EQ(keys.size(), 2u);
    EXPECT_LT(keys[1].camera.distance_m, 0.8 * keys[0].camera.distance_m);
    click("Save path");
    const auto file = folder_.path() / "couloir/recordings/landslide.camera.toml";
    EXPECT_NE(last_notice().find(file.string()), std::string::npos) << last_notice();
    EXPECT_EQ(load_camera_path(file).value(), keys);
    click("##Remove key 1");
    ASSERT_EQ(app_->path().keys().size(), 1u);
    click("Load path");
    ASSERT_EQ(app_->path().keys(), keys);

    click("Play the path");
    ASSERT_TRUE(app_->path().plays());
    screen_.resize_to(160, 90);
    bool was_between = false;
    wait_until([&] {
        frames(1);
        const double away = app_->camera().distance_m;
        was_between |= away > 1.05 * keys[1].camera.distance_m && away < 0.95 * keys[0].camera.distance_m;
        return !app_->path().plays();
    });
    EXPECT_TRUE(was_between);
    EXPECT_NEAR(app_->camera().distance_m, keys[1].camera.distance_m, 1);
    EXPECT_NEAR(app_->sandbox().session().seconds(), keys[1].time_s, 0.1);

    tap(Key::kSpace);
    widen();
    click("Play the path");
    screen_.move(650, 400);
    screen_.happen({WheelEvent{1, {}}});
    frames(2);
    EXPECT_FALSE(app_->path().plays()) << "who moves the camera ends it";
    click(fmt::format("{:.1f} s", keys[0].time_s).c_str());
    frames(4);
    EXPECT_NEAR(app_->sandbox().session().seconds(), keys[0].time_s, 0.02);
    EXPECT_NEAR(app_->camera().distance_m, keys[0].camera.distance_m, 1);
    EXPECT_TRUE(app_->clock().paused());
    EXPECT_TRUE(app_->sandbox().watches());
    EXPECT_FALSE(app_->sandbox().verdict()->parted);
}

TEST_F(Playing, jumps_to_marks_and_skips_to_the_end_of_a_slide) {
    begin();
    tap(Key::kEnd);
    EXPECT_NE(last_notice().find("Nothing moves"), std::string::npos) << last_notice();
    frames(30);
    stroke(20);
    const std::int64_t done = app_->sandbox().commands_so_far().front().tick;
    tap(Key::kEnd);
    const std::int64_t before = state().tick;
    frames(3);
    EXPECT_GT(state().tick, before + 3) << "faster than the screen";
    wait_until([&] {
        frames(1);
        return sim::at_rest(state()) || shows("Result");
    });
    const StateLine end = line();
    tap(Key::kComma, {.control = true});
    frames(2);
    EXPECT_NEAR(static_cast<double>(state().tick), static_cast<double>(done), 5);
    tap(Key::kComma, {.control = true});
    EXPECT_NE(last_notice().find("No mark"), std::string::npos) << last_notice();
    tap(Key::kEnd);
    wait_until([&] {
        frames(1);
        return !app_->sandbox().looks_back();
    });
    EXPECT_GE(state().tick, end.tick);
    expect_recording_replays();
}

TEST_F(Playing, runs_back_to_the_beginning_and_stands_there) {
    begin();
    const StateLine first = line();
    frames(20);
    tap(Key::kBackspace);
    frames(200);
    EXPECT_EQ(state().tick, 0);
    EXPECT_TRUE(app_->clock().paused());
    EXPECT_FALSE(app_->clock().runs_back());
    EXPECT_LE(first.tick, 4);
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    if (!std::filesystem::exists(folder)) return files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

TEST_F(Playing, begins_another_world_at_normal_speed_and_not_paused) {
    begin();
    tap(Key::kEqual);
    tap(Key::kSpace);
    tap(key('R'), {.control = true});
    EXPECT_TRUE(app_->clock().paused()) << "the same one goes on as it was";
    for (const char* file : {"assets/scenes/landslide.toml", "assets/recordings/landslide.couloir"}) {
        app_->frame();
        screen_.drop({support::source_dir() / file});
        frames(5);
        EXPECT_FALSE(app_->clock().paused()) << file;
        EXPECT_EQ(app_->clock().speed(), 1) << file;
        EXPECT_GT(state().tick, 0) << file;
        tap(Key::kEqual);
        tap(Key::kSpace);
    }
}

TEST_F(Playing, shows_no_ring_while_panels_are_hidden_except_during_a_stroke) {
    begin();
    tap(Key::kSpace);
    tap(Key::kTab);
    const auto picture_at = [&](double x) {
        screen_.move(x, kAtY);
        frames(60);
        return screen_.picture().pixels;
    };
    frames(1000);  // until no notice is fading
    const auto without = picture_at(kAtX);
    EXPECT_EQ(picture_at(kAtX + 40), without);
    screen_.press(Button::kLeft);
    frames(3);
    EXPECT_NE(screen_.picture().pixels, without);
    screen_.release(Button::kLeft);
    frames(3);
    tap(Key::kTab);
    const auto with = picture_at(kAtX);
    EXPECT_NE(picture_at(kAtX + 40), with);
}

TEST_F(Playing, greys_all_tools_alike_in_the_past) {
    screen_.resize_to(1280, 720);
    begin();
    stroke(5);
    frames(20);
    const auto brightest = [&](const char* label) {
        const auto at = app_->panels().find(label).value();
        const render::Picture shown = screen_.picture();
        int most = 0;
        for (int y = static_cast<int>(at.y); y < at.y + at.height; ++y)
            for (int x = static_cast<int>(at.x); x < at.x + at.width; ++x)
                most = std::max<int>(most, shown.pixels[static_cast<std::size_t>(3 * (y * shown.width + x))]);
        return most;
    };
    // In red, which the accent has little of and letters have much of.
    for (const char* label : {"Dig", "Blast", "Radius", "Standing"})
        EXPECT_GT(brightest(label), 180) << label;
    tap(Key::kComma);
    screen_.move(5, 300);
    frames(3);
    ASSERT_TRUE(app_->sandbox().looks_back());
    for (const char* label : {"Pour", "Dig", "Blast"}) EXPECT_LT(brightest(label), 150) << label;
    for (const char* option : {"Radius", "Standing"}) EXPECT_FALSE(shows(option)) << option;
}

TEST_F(Playing, opens_on_a_view_that_has_room_between_the_bars) {
    screen_.resize_to(1280, 720);
    begin("landslide");
    const double own = app_->sandbox().scenario().camera.value().field_of_view_deg;
    const render::Camera first = app_->camera();
    EXPECT_GT(first.field_of_view_deg, own + 5);
    EXPECT_EQ(first.distance_m, app_->sandbox().scenario().camera->distance_m);
    tap(Key::kTab);
    tap(Key::kHome);
    frames(200);
    EXPECT_DOUBLE_EQ(app_->camera().field_of_view_deg, own) << "there are no bars now";
}

// On a small slope, of three seconds, and asks for one blast.
TEST_F(Playing, tells_what_a_slide_in_free_play_came_to_and_goes_back_to_before_it) {
    begin("winter-valley", 40);
    for (int i = 0; i < 4; ++i) tap(Key::kEqual);  // 16 times as fast
    tap(key('3'));
    stroke(1);
    EXPECT_FALSE(shows("Verdict"));
    for (int i = 0; i < 25 && !shows("Verdict"); ++i) pass(20);
    EXPECT_TRUE(shows("Verdict"));
    EXPECT_TRUE(shows("Swept along"));
    click("Look around");
    EXPECT_FALSE(shows("Verdict"));
    frames(60);
    EXPECT_FALSE(shows("Verdict"));

    stroke(1);  // another one
    for (int i = 0; i < 25 && !shows("Verdict"); ++i) pass(20);
    const std::int64_t ended = state().tick;
    click("Again");
    EXPECT_FALSE(shows("Verdict"));
    EXPECT_LT(state().tick, ended);
    EXPECT_EQ(app_->sandbox().actions(), 1u);
}

TEST_F(Playing, saves_the_world_as_it_stands_and_begins_it_again) {
    screen_.resize_to(1280, 720);
    begin("winter-valley", 40);
    tap(key('3'));
    blast_at(640, 330);
    pass(60);
    ASSERT_GT(mass().rolling, 0);
    tap(function_key(2));
    frames(3);
    click("Name of this world");
    screen_.type("The wood, blasted");
    frames(2);
    click("Save this world");
    const auto folder = folder_.path() / "couloir/scenes";
    ASSERT_EQ(app_->catalogue().own_of(ShelfKind::kWorld).size(), 1u) << last_notice();
    const std::filesystem::path file = app_->catalogue().own_of(ShelfKind::kWorld)[0].file;
    EXPECT_EQ(file, folder / "The wood, blasted.couloir");
    EXPECT_TRUE(render::read_png(picture_of(file), 3));
    EXPECT_NE(last_notice().find(file.string()), std::string::npos) << last_notice();
    const auto recording = read_recording(file);
    ASSERT_TRUE(recording) << recording.error().sentence;
    EXPECT_TRUE(is_world(*recording));
    EXPECT_NEAR(recording->header.scenario.camera->distance_m, app_->camera().distance_m, 1e-9);

    frames(30);
    tap(function_key(9));
    click("My hill");
    frames(2);
    ASSERT_TRUE(shows("Rename"));
    click("Start");
    frames(2);
    EXPECT_FALSE(app_->sandbox().watches());
    EXPECT_EQ(app_->sandbox().scenario().scene, file.stem());
    EXPECT_LT(state().tick, 5);
    EXPECT_GT(mass().rolling, 0) << "what moved starts from rest";
    ASSERT_TRUE(app_->recording());
    EXPECT_NE(app_->recording()->string().find("The-wood--blasted"), std::string::npos);
    tap(function_key(2));
    blast_at(640, 330);
    frames(30);
    expect_recording_replays();
}

TEST_F(Playing, saves_no_world_of_the_past_and_says_why_one_cannot_be_written) {
    screen_.resize_to(1280, 720);
    begin("winter-valley", 40);
    tap(function_key(2));
    frames(3);
    std::filesystem::create_directory(folder_.path() / "couloir");
    std::ofstream(folder_.path() / "couloir/scenes") << "a file in place of the folder";
    click("Save this world");
    EXPECT_NE(last_notice().find("not saved"), std::string::npos) << last_notice();
    EXPECT_TRUE(app_->catalogue().own_of(ShelfKind::kWorld).empty());
    std::filesystem::remove(folder_.path() / "couloir/scenes");

    tap(Key::kComma);
    frames(3);
    click("Save this world");
    EXPECT_TRUE(app_->catalogue().own_of(ShelfKind::kWorld).empty()) << "looking back";
}

TEST_F(Playing, makes_a_challenge_of_a_slide_that_can_be_watched_and_then_tried) {
    screen_.resize_to(1280, 720);
    begin("winter-valley", 40);
    for (int i = 0; i < 4; ++i) tap(Key::kEqual);
    tap(key('3'));
    blast_at(640, 330);
    for (int i = 0; i < 25 && !shows("Verdict"); ++i) pass(20);
    ASSERT_TRUE(shows("Make it a challenge"));
    click("Make it a challenge");
    wait_until([&, waits = 0]() mutable {
        if (++waits % 100 == 0) frames(1);  // which takes time from the other thread
        return !app_->is_making_challenge();
    });
    frames(2);
    ASSERT_EQ(app_->catalogue().own_of(ShelfKind::kChallenge).size(), 1u) << last_notice();
    const std::filesystem::path file = app_->catalogue().own_of(ShelfKind::kChallenge)[0].file;
    EXPECT_NE(last_notice().find(file.string()), std::string::npos) << last_notice();

    tap(function_key(9));
    frames(2);
    click("My hill");
    frames(2);
    click("Start");
    frames(2);
    EXPECT_TRUE(app_->sandbox().watches());
    frames(3);
    ASSERT_TRUE(shows("Try it yourself"));
    EXPECT_TRUE(shows("Task"));
    frames(20);
    click("Try it yourself");
    EXPECT_FALSE(app_->sandbox().watches());
    EXPECT_FALSE(shows("Try it yourself"));
    EXPECT_LT(state().tick, 10);
    EXPECT_FALSE(app_->sandbox().was_touched());
    EXPECT_TRUE(shows("Blast: 1 of 1 left"));
    tap(function_key(2));
    frames(2);
    const std::int64_t begun = state().tick;
    blast_at(640, 330);
    for (int i = 0; i < 4; ++i) tap(Key::kEqual);
    for (int i = 0; i < 50 && !shows("Verdict"); ++i) pass(20);
    ASSERT_TRUE(shows("Verdict"));
    EXPECT_TRUE(shows("Try again"));
    ASSERT_EQ(app_->best_runs().size(), 1u) << last_notice() << begun;
    click("Try again");
    EXPECT_FALSE(app_->sandbox().watches());
    EXPECT_TRUE(app_->sandbox().scenario().goal);
}

// Over the shipped recording, with two stops at its beginning and one at its end.
TEST_F(Playing, gives_a_lesson_that_halts_at_each_stop_and_never_touches_the_world) {
    const auto shipped = find_asset(AssetKind::kLesson, "where-will-it-stop");
    ASSERT_TRUE(shipped);
    std::filesystem::copy_file(std::filesystem::path(*shipped).replace_extension(".couloir"),
                               folder_.path() / "short.couloir");
    const auto file = folder_.path() / "short.toml";
    std::ofstream(file) << R"(title = "A trial"
recording = "short.couloir"
[[stop]]
time = 0
heading = "Begin"
text = "Look."
question = "Where?"
answers = ["Here", "There"]
right = 2
why = "So it is."
[[stop]]
time = 0.1
heading = "Go"
text = "Guess."
guess = "runout"
[[stop]]
time = 56
heading = "End"
text = "It ran {runout}."
)";
    auto loaded = open_lesson(file.string(), {});
    ASSERT_TRUE(loaded) << loaded.error().sentence;
    const std::int64_t end = loaded->watched->last_tick();
    auto begun = App::begin(screen_, std::move(*loaded), sim::StepOptions{}, std::nullopt, tier_);
    ASSERT_TRUE(begun) << begun.error().sentence;
    app_ = std::move(*begun);
    screen_.resize_to(960, 540);
    frames(4);
    EXPECT_EQ(state().tick, 0);
    EXPECT_TRUE(app_->clock().paused());
    ASSERT_TRUE(shows("Question"));
    click("There");
    frames(2);
    EXPECT_TRUE(shows("Verdict"));
    EXPECT_EQ(app_->lesson()->note()->answer, 1u);
    stroke(1);
    EXPECT_FALSE(app_->lesson()->guessed()) << "none is asked";
    click("Go on");
    EXPECT_FALSE(shows("Lesson"));
    frames(12);
    EXPECT_EQ(state().tick, 6);
    ASSERT_TRUE(shows("Guess"));

    // Time can be scrubbed meanwhile, and continues from the stop.
    tap(Key::kComma), tap(Key::kComma);
    frames(3);
    EXPECT_EQ(state().tick, 4);
    EXPECT_TRUE(shows("Guess"));
    stroke(1);
    ASSERT_TRUE(app_->lesson()->guessed());
    EXPECT_TRUE(shows("Your guess"));
    tap(Key::kSpace);
    frames(2);
    EXPECT_FALSE(shows("Lesson"));
    EXPECT_GE(state().tick, 6);
    screen_.resize_to(160, 90);
    tap(Key::kEnd);
    for (int i = 0; i < 600 && state().tick < end; ++i) frames(1);
    screen_.resize_to(960, 540);
    frames(6);
    EXPECT_EQ(state().tick, end);
    EXPECT_TRUE(app_->sandbox().watches()) << "it is not taken over by itself";
    EXPECT_TRUE(shows("Guess"));
    ASSERT_TRUE(app_->lesson()->note()->guess_off);
    EXPECT_GT(*app_->lesson()->note()->guess_off, 0);
    stroke(1);
    EXPECT_FALSE(app_->sandbox().was_touched()) << "read-only to its end";

    click("Start again");
    frames(4);
    EXPECT_EQ(state().tick, 0);
    EXPECT_TRUE(shows("Question"));
    EXPECT_FALSE(app_->lesson()->guessed());
    tap(Key::kEnter);
    EXPECT_FALSE(app_->sandbox().watches());
    EXPECT_FALSE(app_->lesson());
}

class FirstMinute : public Playing {
  protected:
    void begin_led(Guide guide, const std::string& what) {
        wishes_.squares = 40;
        auto loaded = open_anything(what, what == Guide::kSlide ? Overrides{} : wishes_);
        ASSERT_TRUE(loaded) << loaded.error().sentence;
        auto begun = App::begin(screen_, std::move(*loaded), sim::StepOptions{}, std::nullopt, Tier::kFast,
                                Remembered{guide, ""});
        ASSERT_TRUE(begun) << begun.error().sentence;
        app_ = std::move(*begun);
        frames(2);
    }
    Guide::Step kept() const { return remembered_guide().guide.step(); }
};

TEST_F(FirstMinute, begins_with_a_slide_that_any_key_ends_without_doing_anything_else) {
    begin_led(Guide(), Guide::kSlide);
    EXPECT_TRUE(app_->sandbox().watches());
    EXPECT_EQ(app_->clock().speed(), 2);
    EXPECT_FALSE(shows("Pause"));
    frames(75);
    EXPECT_FALSE(sim::at_rest(state()));
    const render::Camera whole = app_->camera();
    frames(5 * 60);
    const render::Camera close = app_->camera();
    EXPECT_LT(close.distance_m, 0.7 * whole.distance_m) << "a shot of the front";
    frames(10);
    EXPECT_EQ(app_->camera(), close) << "a camera that stands";
    tap(Key::kSpace);
    frames(2);
    EXPECT_FALSE(app_->sandbox().watches());
    EXPECT_EQ(app_->sandbox().scenario().scene, Guide::kMountain);
    EXPECT_FALSE(app_->clock().paused());
    EXPECT_EQ(app_->clock().speed(), 1);
    EXPECT_EQ(app_->brush().tool, Tool::kBlast);
    EXPECT_TRUE(shows("Your turn"));
    EXPECT_EQ(kept(), Guide::Step::kBlast);
    EXPECT_FALSE(shows("Try here"));
    frames(8 * 60 + 10);
    EXPECT_TRUE(shows("Try here"));
}

TEST_F(FirstMinute, leads_to_a_first_challenge_by_real_keys_and_clicks) {
    begin_led(Guide(Guide::Step::kBlast), Guide::kMountain);
    for (int i = 0; i < 4; ++i) tap(Key::kEqual);  // 16 times as fast
    tap(key('3'));
    stroke(1);
    EXPECT_EQ(app_->guide()->step(), Guide::Step::kRewind);
    const auto close_card = [&] {  // in whose place this small window shows the hint
        for (int i = 0; i < 30 && !shows("Verdict"); ++i) pass(20);
        click("Look around");
        frames(2);
    };
    close_card();
    EXPECT_TRUE(shows("Too much?"));
    tap(Key::kBackspace);
    frames(5);
    EXPECT_EQ(app_->guide()->step(), Guide::Step::kGoOn);
    tap(Key::kBackspace);
    frames(1);
    EXPECT_TRUE(shows("Far enough?"));
    tap(Key::kEnter);
    frames(2);
    EXPECT_TRUE(shows("Now pour"));
    tap(key('1'));
    stroke(10);
    EXPECT_EQ(app_->guide()->step(), Guide::Step::kChallenge);
    close_card();
    EXPECT_TRUE(shows("A challenge"));
    click("Try it");
    frames(2);
    EXPECT_EQ(app_->sandbox().scenario().scene, Guide::kChallenge);
    EXPECT_FALSE(shows("A challenge"));
    EXPECT_EQ(kept(), Guide::Step::kDone);
}

TEST_F(FirstMinute, lets_each_hint_be_closed_and_shown_again) {
    begin_led(Guide(Guide::Step::kBlast), Guide::kMountain);
    for (const char* heading : {"Your turn", "Too much?"}) {
        EXPECT_TRUE(shows(heading));
        click("Close hint");
        frames(2);
        EXPECT_FALSE(shows(heading));
    }
    tap(function_key(2));
    frames(2);
    click("Show hints again");
    frames(2);
    EXPECT_TRUE(shows("Your turn"));
}

class PlayingAChallenge : public Playing {
  protected:
    PlayingAChallenge() {
        screen_.resize_to(1280, 720);
        const auto scene = folder_.path() / "small.toml";
        std::ofstream(scene) << support::slope_scene("A small challenge", 40) << kRest;
        begin(scene.string(), 0);
    }
    void blast() { blast_at(640, 330); }
    // The same, and the scene does something itself.
    void open_with_an_event() {
        const auto scene = folder_.path() / "event.toml";
        std::ofstream(scene) << support::slope_scene("A challenge with an event", 40) << kRest
                             << "[[command]]\nat = 2\nblast = { x = 80, y = 100, radius = 9, depth = 1 }\n";
        screen_.drop({scene});
        frames(2);
        ASSERT_EQ(app_->sandbox().scenario().title, "A challenge with an event");
    }
    // As couloir replay --score computes it.
    static Outcome<Score> replayed_score(const Recording& recording) {
        auto session = Session::begin(recording.header.scenario, sim::StepOptions{}, std::nullopt);
        Referee referee(recording.header.scenario, recording.commands);
        Watchers watchers;
        watchers.after_tick = [&](const Session& now) { referee.see(now); };
        EXPECT_TRUE(
            play_headless(*session, recording.commands, Until::after(recording.last_tick()), watchers, ""));
        return referee.decide();
    }
    void go_on_to_the_card() {
        for (int i = 0; i < 100 && !shows("Verdict"); ++i) pass(20);
        ASSERT_TRUE(shows("Verdict"));
    }

  private:
    static constexpr const char* kRest = R"([camera]
target = [80, 72, -48]
azimuth = 200
elevation = 30
distance = 200
[light]
azimuth = 255
[goal]
say = "Move something."
learn = "Blasts move things."
medals = [1, 10000, 12000]
latest = 3
[[goal.tool]]
command = "blast"
count = 1
radius = 12
depth = 1
[[goal.score]]
measure = "eroded"
)";
};

TEST_F(PlayingAChallenge, tells_its_task_and_what_a_try_came_to) {
    EXPECT_TRUE(shows("Task"));
    EXPECT_TRUE(shows("Blast: 1 of 1 left"));
    EXPECT_FALSE(shows("Pour")) << "is no tool of it";
    EXPECT_FALSE(shows("Radius")) << "leaves no choice";
    EXPECT_EQ(app_->brush().tool, Tool::kBlast);
    EXPECT_EQ(app_->brush().radius, 12);
    tap(key('1'));
    EXPECT_EQ(last_notice(), "Pour is no tool of this challenge");
    EXPECT_EQ(app_->brush().tool, Tool::kBlast);

    blast();
    EXPECT_TRUE(shows("Blast: 0 of 1 left"));
    go_on_to_the_card();
    frames(2);
    EXPECT_TRUE(shows("Try again"));

    tap(Key::kComma);  // a look back hides the card
    while (state().tick >= 180) tap(Key::kComma);
    EXPECT_FALSE(shows("Verdict"));
    tap(Key::kEscape);
    ASSERT_TRUE(app_->finish());
    const auto recording = read_recording(*app_->recording());
    ASSERT_TRUE(recording) << recording.error().sentence;
    ASSERT_TRUE(recording->claim);
    EXPECT_EQ(recording->claim->tick, recording->commands.at(0).tick + 180);
    EXPECT_EQ(recording->claim->medal, 1);
}

TEST_F(PlayingAChallenge, waits_for_its_player_if_its_scene_is_going_to_act_and_counts_the_time_until_then) {
    screen_.resize_to(640, 360);
    EXPECT_FALSE(app_->clock().paused());
    open_with_an_event();
    frames(10);
    EXPECT_TRUE(app_->clock().paused());
    EXPECT_EQ(state().tick, 0);
    EXPECT_TRUE(shows("Ready"));
    EXPECT_TRUE(shows("in 0:02"));
    tap(Key::kSpace);
    frames(70);
    EXPECT_FALSE(shows("Ready"));
    EXPECT_TRUE(shows("in 0:01"));
    frames(70);
    EXPECT_FALSE(shows("in 0:01"));
    EXPECT_FALSE(sim::at_rest(state()));
    blast_at(320, 165);  // else its recording would not stay
    EXPECT_TRUE(app_->sandbox().was_touched());
    const std::filesystem::path tried = *app_->recording();
    tap(key('R'), {.control = true});
    frames(5);
    EXPECT_TRUE(app_->clock().paused());
    EXPECT_EQ(state().tick, 0);
    screen_.drop({tried});
    frames(5);
    EXPECT_FALSE(app_->clock().paused()) << "it is watched";
    click("Try it yourself");
    frames(5);
    EXPECT_TRUE(app_->clock().paused());
    EXPECT_EQ(state().tick, 0);
}

TEST_F(PlayingAChallenge, begins_with_its_own_camera_and_restarts_with_that_of_the_player) {
    const render::Camera own = app_->camera();
    screen_.move(640, 330);
    screen_.happen({WheelEvent{5, {}}});
    frames(60);
    const double zoomed = app_->camera().distance_m;
    ASSERT_LT(zoomed, 0.9 * own.distance_m);
    tap(key('R'), {.control = true});
    frames(3);
    EXPECT_NEAR(app_->camera().distance_m, zoomed, 0.01);
    open_with_an_event();  // on the same ground
    EXPECT_EQ(app_->camera().distance_m, own.distance_m);
    EXPECT_EQ(app_->camera().target, own.target);
}

TEST_F(PlayingAChallenge, shows_a_map_of_the_try_and_plays_it_once_more_from_its_front) {
    blast();
    const std::int64_t first = state().tick - 3;
    go_on_to_the_card();
    frames(2);
    ASSERT_TRUE(shows("Map"));
    const render::Camera before = app_->camera();
    click("Map");  // its middle is that of the slide, and of the grid's width
    screen_.resize_to(640, 360);
    frames(120);
    EXPECT_NEAR(app_->camera().target.x, 80, 40);
    EXPECT_NE(app_->camera().target, before.target);
    EXPECT_NEAR(app_->camera().distance_m, before.distance_m, 1e-9);

    screen_.resize_to(1280, 720);
    frames(2);
    tap(Key::kSpace);
    const StateLine live = line();
    click("From the front");
    screen_.resize_to(640, 360);
    for (int i = 0; i < 100 && state().tick >= live.tick; ++i) frames(1);
    EXPECT_NEAR(static_cast<double>(state().tick), static_cast<double>(first), 8);
    EXPECT_TRUE(app_->sandbox().looks_back());
    EXPECT_EQ(app_->clock().speed(), 2);
    EXPECT_FALSE(shows("Verdict"));
    frames(30);
    EXPECT_GT(glm::cos(glm::radians(app_->camera().azimuth_deg - 180)), 0.5)
        << "from the south, where it went";
    EXPECT_LT(app_->camera().elevation_deg, 0) << "it looks up";
    go_on_to_the_card();
    frames(3);
    EXPECT_EQ(app_->clock().speed(), 1);
    EXPECT_GE(state().tick, live.tick) << "back in the present";
    EXPECT_FALSE(app_->sandbox().looks_back());
    EXPECT_EQ(app_->best_runs().size(), 1u);
}

TEST_F(PlayingAChallenge, forgets_what_a_try_came_to_that_is_undone) {
    blast();
    go_on_to_the_card();
    tap(key('Z'), {.control = true});
    frames(2);
    EXPECT_FALSE(shows("Verdict"));
    EXPECT_TRUE(shows("Blast: 1 of 1 left"));
    ASSERT_TRUE(app_->finish());
    EXPECT_EQ(app_->sandbox().session().try_ended_at(), std::nullopt);
}

TEST_F(PlayingAChallenge, keeps_the_recording_of_a_run_that_proves_its_score) {
    EXPECT_TRUE(app_->best_runs().empty());
    blast();
    go_on_to_the_card();
    ASSERT_EQ(app_->best_runs().size(), 1u);
    const BestRun run = app_->best_runs().front();
    const auto recording = read_recording(run.file);
    ASSERT_TRUE(recording) << recording.error().sentence;
    EXPECT_FALSE(recording->warning);
    ASSERT_TRUE(recording->claim);
    EXPECT_EQ(recording->end, recording->claim->tick);
    const auto score = replayed_score(*recording);
    ASSERT_TRUE(score) << score.error().sentence;
    EXPECT_EQ(score->claim(), *recording->claim);
    EXPECT_EQ(score->points, run.score);
    EXPECT_EQ(score->medal, run.medal);
}

TEST_F(PlayingAChallenge, keeps_a_try_once_even_if_it_is_undone_and_done_again) {
    blast();
    go_on_to_the_card();
    frames(30);
    EXPECT_EQ(app_->best_runs().size(), 1u);
    tap(key('Z'), {.control = true});
    tap(key('Y'), {.control = true});
    for (int i = 0; i < 100 && state().tick < 190; ++i) pass(20);
    EXPECT_EQ(app_->best_runs().size(), 1u);
}

TEST_F(PlayingAChallenge, keeps_no_run_that_is_only_watched) {
    blast();
    go_on_to_the_card();
    ASSERT_EQ(app_->best_runs().size(), 1u);
    const auto before = app_->best_runs().front().file;
    screen_.drop({before});
    frames(3);
    ASSERT_TRUE(app_->sandbox().watches());
    EXPECT_EQ(app_->best_runs().size(), 1u) << "it is a run of the same challenge";
    go_on_to_the_card();
    pass(300);
    ASSERT_EQ(app_->best_runs().size(), 1u);
    EXPECT_EQ(app_->best_runs().front().file, before);
}

// Where the flow of a recorded run had been after so many ticks since its first command.
std::vector<std::uint8_t> reached_by(const std::filesystem::path& file, std::int64_t ticks) {
    const Recording recording = read_recording(file).value();
    Session session = Session::begin(recording.header.scenario, {}, std::nullopt).value();
    const auto until = Until::after(recording.commands.front().tick + ticks);
    EXPECT_TRUE(play_headless(session, recording.commands, until, {}, ""));
    std::vector<std::uint8_t> reached;
    for (const float depth : session.peaks().depth) reached.push_back(depth >= 0.1f ? 255 : 0);
    return reached;
}

class PlayingAgain : public PlayingAChallenge {
  protected:
    PlayingAgain() {
        setenv("HOME", folder_.path().c_str(), 1);
        setenv("XDG_CONFIG_HOME", folder_.path().c_str(), 1);
    }
    // Returns how many there are then.
    std::size_t take_screenshot() {
        const std::string before = last_notice();
        tap(function_key(12));
        for (int i = 0; i < 1000 && last_notice() == before; ++i) frames(1);
        return files_in(folder_.path() / "couloir/screenshots").size();
    }
    // After a first try; then blasts once more, elsewhere.
    void play_again() {
        tap(key('R'), {.control = true});
        frames(10);
        screen_.move(600, 330);
        frames(1);
        screen_.press(Button::kLeft);
        frames(2);
        screen_.release(Button::kLeft);
        frames(1);
    }
    void wait_for_the_ghost() {
        wait_until([&] {
            frames(1);
            return app_->ghost().version() != 0;
        });
        ASSERT_NE(app_->ghost().version(), 0);
    }
    std::vector<std::uint8_t> ghost() const {
        return {app_->ghost().inside().begin(), app_->ghost().inside().end()};
    }
    std::int64_t since_action() const { return state().tick - *app_->sandbox().first_action(); }
};

TEST_F(PlayingAgain, has_a_ghost_that_is_where_the_best_run_was_at_the_same_time) {
    blast();
    EXPECT_EQ(app_->ghost().version(), 0) << "there is none in the first try";
    go_on_to_the_card();
    EXPECT_EQ(app_->ghost().version(), 0);
    const auto best = app_->best_runs().front().file;
    play_again();
    wait_for_the_ghost();
    frames(2);
    EXPECT_TRUE(shows("Ghost"));
    int compared = 0;
    for (std::int64_t before = 0; since_action() < 160; frames(1)) {
        if (app_->ghost().version() == before) continue;
        before = app_->ghost().version();
        const std::int64_t step = since_action() / RunExtent::kStep;
        EXPECT_EQ(ghost(), reached_by(best, step * RunExtent::kStep)) << step;
        ++compared;
    }
    EXPECT_GT(compared, 2);
    EXPECT_TRUE(std::ranges::count(ghost(), 255) > 10);
}

TEST_F(PlayingAgain, forgets_what_the_ghost_came_to_when_the_challenge_restarts_or_another_one_begins) {
    blast();
    go_on_to_the_card();
    play_again();
    wait_for_the_ghost();
    frames(2);
    ASSERT_TRUE(shows("Ghost"));
    tap(key('R'), {.control = true});
    frames(3);
    EXPECT_FALSE(shows("Ghost"));
    play_again();
    wait_for_the_ghost();
    frames(2);
    ASSERT_TRUE(shows("Ghost"));
    open_with_an_event();
    EXPECT_FALSE(shows("Ghost"));
}

TEST_F(PlayingAgain, shows_no_ghost_if_the_display_says_so_and_never_in_a_screenshot) {
    blast();
    go_on_to_the_card();
    play_again();
    wait_for_the_ghost();
    tap(Key::kSpace);
    EXPECT_EQ(take_screenshot(), 1u);
    ASSERT_NE(app_->ghost().version(), 0);
    tap(function_key(4));
    frames(3);
    click("Ghost");
    frames(1);
    EXPECT_FALSE(app_->display().ghost);
    EXPECT_EQ(app_->ghost().version(), 0);
    EXPECT_EQ(take_screenshot(), 2u);
    const auto shots = files_in(folder_.path() / "couloir/screenshots");
    ASSERT_EQ(shots.size(), 2u);
    EXPECT_EQ(render::read_png(shots[0], 3).value().values, render::read_png(shots[1], 3).value().values);
}

TEST_F(PlayingAgain, has_no_ghost_of_a_run_whose_name_claims_more_than_it_scores) {
    blast();
    go_on_to_the_card();
    const auto best = app_->best_runs().front().file;
    const auto false_claim = best.parent_path() / "9999999_gold_2026-11-26_12-58-00_0123456789abcdef.couloir";
    std::filesystem::copy_file(best, false_claim);
    std::ofstream(best.parent_path() / "9999998_gold_2026-11-26_12-58-00_0123456789abcdef.couloir")
        << "no recording";
    play_again();
    ASSERT_EQ(app_->best_runs().front().file, false_claim);
    wait_for_the_ghost();
    EXPECT_EQ(ghost(), reached_by(best, since_action() / RunExtent::kStep * RunExtent::kStep));
    std::string told;
    for (std::size_t i = 0; i < app_->notices().size(); ++i) told += app_->notices()[i].sentence + '\n';
    EXPECT_NE(told.find(false_claim.string() + ": its name claims a score of 9999999 (gold)"),
              std::string::npos)
        << told;
    EXPECT_NE(told.find("9999998_gold"), std::string::npos) << told;
}

TEST_F(Playing, tells_the_best_run_of_a_challenge_that_ships_and_not_of_another_of_its_name) {
    const auto folder = folder_.path() / "couloir/best";
    const auto put = [&](const std::string& challenge, const char* name) {
        std::filesystem::create_directories(folder / challenge);
        std::ofstream(folder / challenge / name) << "a recording";
    };
    put("quarry-0123456789abcdef", "9999_gold_2026-11-26_12-58-00_0123456789abcdef.couloir");
    put("quarry-" + challenge_id(load_scene("quarry", {})->scenario),
        "3600_bronze_2026-11-26_12-58-00_0123456789abcdef.couloir");
    begin();
    const auto quarry = [&] {
        const auto& scenes = app_->catalogue().scenes;
        return std::ranges::find(scenes, "quarry", &Catalogue::Entry::name);
    };
    ASSERT_NE(quarry(), app_->catalogue().scenes.end());
    for (int i = 0; i < 3000 && !quarry()->best; ++i) frames(1);
    ASSERT_TRUE(quarry()->best);
    EXPECT_EQ(quarry()->best->score, 3600);
    EXPECT_EQ(quarry()->best->medal, 1);
    EXPECT_TRUE(app_->best_runs().empty()) << "it is not open";
}

TEST_F(Playing, reads_pictures_of_cards_of_any_size_and_does_without_those_that_are_damaged) {
    const std::string jpeg = read_text(support::source_dir() / "assets/scenes/flow-disc.jpg").value();
    const auto put = [&](const char* name, const std::string& bytes) {
        std::ofstream(folder_.path() / name, std::ios::binary) << bytes;
    };
    put("first.jpg", jpeg);
    put("broken.jpg", "no picture");
    put("cut.jpg", jpeg.substr(0, 200));
    for (const auto& [name, width, height] : {std::tuple("small.png", 1, 1), {"high.png", 40, 900}})
        ASSERT_TRUE(render::write_png(
            {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), 90)},
            folder_.path() / name));
    std::vector<ui::ScenePictures::Source> sources;
    for (const char* name : {"first.jpg", "missing.jpg", "broken.jpg", "cut.jpg", "small.png", "high.png"})
        sources.push_back({name, folder_.path() / name});
    ui::ScenePictures pictures;
    pictures.show(sources);
    wait_until([&] {
        pictures.upload_if_read();
        return pictures.of("high.png").has_value();
    });
    const auto first = pictures.of("first.jpg"), last = pictures.of("high.png");
    ASSERT_TRUE(first);
    EXPECT_TRUE(pictures.of("small.png"));
    EXPECT_EQ(first->texture, last->texture);
    EXPECT_LT(first->to.y, first->from.y) << "the lowest row comes first";
    EXPECT_GT(last->to.y, first->from.y - 0.01f);
    for (const char* none : {"missing.jpg", "broken.jpg", "elsewhere"})
        EXPECT_FALSE(pictures.of(none)) << none;
    pictures.show({{"only", folder_.path() / "small.png"}});
    wait_until([&] {
        pictures.upload_if_read();
        return pictures.of("only").has_value();
    });
    EXPECT_FALSE(pictures.of("first.jpg"));
}

// As play() does without --record.
class Keeping : public Playing {
  protected:
    void begin_in_folder(const std::string& what) {
        wishes_.squares = 80;
        auto loaded = open_anything(what, wishes_);
        ASSERT_TRUE(loaded) << loaded.error().sentence;
        auto begun = App::begin(screen_, std::move(*loaded), sim::StepOptions{}, std::nullopt, tier_);
        ASSERT_TRUE(begun) << begun.error().sentence;
        app_ = std::move(*begun);
        frames(2);
    }
    std::size_t kept() {
        EXPECT_TRUE(app_->finish());
        const auto files = files_in(folder_.path() / "couloir/recordings");
        return static_cast<std::size_t>(std::ranges::count_if(
            files, [](const std::filesystem::path& file) { return file.extension() == ".couloir"; }));
    }
};

TEST_F(Playing, stands_still_behind_the_menu_which_takes_every_click_and_key) {
    begin();
    stroke(5);
    tap(Key::kEscape);
    ASSERT_TRUE(app_->panels().shows_menu());
    const StateLine before = line();
    const Tool tool = app_->brush().tool;
    stroke(5);
    tap(key('3'));
    tap(Key::kBackspace);
    frames(10);
    EXPECT_EQ(line(), before);
    EXPECT_EQ(app_->brush().tool, tool);
    tap(Key::kEscape);
    EXPECT_FALSE(app_->panels().shows_menu());
    frames(5);
    EXPECT_GT(line().tick, before.tick);
    expect_recording_replays();
}

TEST_F(Playing, draws_the_line_of_a_cross_section_without_a_stroke) {
    screen_.resize_to(1280, 720);
    begin();
    tap(function_key(7));
    frames(3);
    click("Draw a line");
    screen_.move(700, 300);
    frames(1);
    screen_.press(Button::kLeft);
    for (int i = 0; i < 10; ++i) {
        screen_.move(700, 300 + 10 * i);
        frames(1);
    }
    screen_.release(Button::kLeft);
    frames(3);
    EXPECT_TRUE(shows("Profile"));
    EXPECT_EQ(mass().poured, 0);
    EXPECT_EQ(app_->sandbox().actions(), 0u);
    EXPECT_FALSE(app_->sandbox().was_touched());
    screen_.press(Button::kLeft);  // the next press is a stroke again
    frames(10);
    screen_.release(Button::kLeft);
    frames(1);
    EXPECT_GT(mass().poured, 0);
    EXPECT_EQ(app_->sandbox().actions(), 1u);
    expect_recording_replays();
}

TEST_F(Playing, is_played_with_a_gamepad_which_comes_and_goes) {
    begin();
    PadState pad;
    const auto set = [&](PadButton button, bool down) {
        pad.buttons[static_cast<std::size_t>(button)] = down;
        screen_.hold(pad);
        frames(1);
    };
    screen_.hold(pad);
    frames(1);
    EXPECT_NE(last_notice().find("scripted pad"), std::string::npos) << last_notice();
    const render::Camera before = app_->camera();
    pad.axes[static_cast<std::size_t>(PadAxis::kRightX)] = 1;
    screen_.hold(pad);
    frames(10);
    EXPECT_GT(std::abs(app_->camera().azimuth_deg - before.azimuth_deg), 1);
    pad.axes[static_cast<std::size_t>(PadAxis::kRightX)] = 0;

    set(PadButton::kLeftBumper, true);
    EXPECT_TRUE(shows("Blast"));
    pad.axes[static_cast<std::size_t>(PadAxis::kLeftX)] = 1;  // the wheel's third of eleven
    set(PadButton::kLeftBumper, true);
    pad.axes[static_cast<std::size_t>(PadAxis::kLeftX)] = 0;
    set(PadButton::kLeftBumper, false);
    frames(1);
    EXPECT_EQ(app_->brush().tool, Tool::kSculpt);

    set(PadButton::kX, true);
    EXPECT_TRUE(app_->clock().paused());
    set(PadButton::kX, false);
    tap(key('1'));
    tap(Key::kSpace);
    pad.axes[static_cast<std::size_t>(PadAxis::kLeftY)] = -0.4f;  // up, from the sky's edge
    screen_.hold(pad);
    frames(2);
    pad.axes[static_cast<std::size_t>(PadAxis::kLeftY)] = 0;
    set(PadButton::kA, true);
    frames(10);
    EXPECT_GT(mass().poured, 0);
    screen_.hold(std::nullopt);  // drawn out while it pours
    frames(2);
    EXPECT_NE(last_notice().find("The gamepad is gone"), std::string::npos) << last_notice();
    const auto poured = mass().poured;
    frames(5);
    EXPECT_EQ(mass().poured, poured);
    expect_recording_replays();
}

TEST_F(Playing, goes_on_from_the_end_of_a_recording_that_the_menu_continues) {
    begin();
    stroke(5);
    frames(20);
    const StateLine end = line();
    const auto recorded = *app_->recording();
    ASSERT_TRUE(app_->finish());
    const auto old = folder_.path() / "couloir/recordings/2026-11-29_10-00-00_alpine-valley.couloir";
    std::filesystem::create_directories(old.parent_path());
    std::filesystem::copy_file(recorded, old);
    app_.reset();
    begin();
    app_->begin_menu();
    frames(2);
    click("Continue");
    wait_until([&] {
        frames(1);
        return !app_->sandbox().watches();
    });
    EXPECT_FALSE(app_->panels().shows_menu());
    EXPECT_GE(line().tick, end.tick);
    stroke(2);
    EXPECT_NE(*app_->recording(), old) << "which stays as it is";
    expect_recording_replays();
}

TEST_F(Keeping, pictures_a_session_and_leaves_a_file_alone_that_is_open) {
    begin_in_folder("alpine-valley");
    const auto open = *app_->recording();
    stroke(20);
    ASSERT_GT(mass().poured, 0);
    tap(Key::kEscape);
    click("Watch");
    EXPECT_FALSE(shows("Rename")) << "the only recording is being written";
    ASSERT_TRUE(app_->finish());
    const auto picture = render::read_png(picture_of(open), 3);
    ASSERT_TRUE(picture) << picture.error();
    EXPECT_EQ(picture->width, 288);
    EXPECT_EQ(picture->height, 162);
    EXPECT_NE(std::ranges::max(picture->values), std::ranges::min(picture->values));
}

TEST_F(Keeping, leaves_no_recording_of_a_session_in_which_nothing_was_done) {
    begin_in_folder("alpine-valley");
    ASSERT_TRUE(app_->recording());
    frames(10);
    tap(key('R'), {.control = true});
    screen_.drop({support::source_dir() / "assets/scenes/landslide.toml"});
    frames(10);
    EXPECT_EQ(kept(), 0u);
    EXPECT_FALSE(app_->recording());
}

TEST_F(Keeping, leaves_no_recording_if_all_that_was_done_was_undone) {
    begin_in_folder("alpine-valley");
    stroke(5);
    tap(key('Z'), {.control = true});
    EXPECT_EQ(kept(), 0u);
}

TEST_F(Keeping, leaves_the_recording_of_a_session_in_which_something_was_done) {
    begin_in_folder("alpine-valley");
    stroke(5);
    tap(key('R'), {.control = true});
    EXPECT_NE(last_notice().find("stays in its recording"), std::string::npos) << last_notice();
    frames(5);
    EXPECT_EQ(kept(), 1u);
}

TEST_F(Keeping, leaves_a_recording_that_a_screenshot_names) {
    begin_in_folder("alpine-valley");
    tap(function_key(12));
    frames(2);
    EXPECT_EQ(kept(), 1u);
}

class Sending : public Playing {
  protected:
    Sending() {
        setenv("HOME", folder_.path().c_str(), 1);
        setenv("XDG_CONFIG_HOME", folder_.path().c_str(), 1);
        write_program("xdg-open", "#!/bin/sh\necho \"$@\" > \"$HOME/opened\"\n");
        setenv("PATH", (folder_.path().string() + ":/usr/bin:/bin").c_str(), 1);
    }
    void write_program(const char* name, const std::string& text) {
        std::ofstream(folder_.path() / name) << text;
        std::filesystem::permissions(folder_.path() / name, std::filesystem::perms::owner_all);
    }
    std::vector<std::filesystem::path> screenshots() const {
        return files_in(folder_.path() / "couloir/screenshots");
    }
    std::vector<std::filesystem::path> shared() const { return files_in(folder_.path() / "couloir/shared"); }
    std::filesystem::path opened() const { return folder_.path() / "opened"; }
    void wait_until_told(const std::string& words) {
        wait_until([&] {
            frames(1);
            return last_notice().find(words) != std::string::npos;
        });
        EXPECT_NE(last_notice().find(words), std::string::npos) << last_notice();
    }
};

TEST_F(Sending, takes_screenshots_of_the_world_alone_at_best_quality_while_panels_are_open) {
    begin();
    tap(Key::kSpace);
    tap(Key::kTab);
    screen_.move(1, 1);  // the ring is not on the ground
    frames(400);         // until no notice is shown
    ASSERT_EQ(app_->image().size(), (ImageSize{640, 360, true}));
    const render::Picture world = screen_.picture();
    const StateLine before = line();
    tap(Key::kTab);
    tap(function_key(2));
    point_at_slope();
    tap(function_key(12));
    EXPECT_EQ(line(), before);
    EXPECT_FALSE(app_->image().size().fine) << "the window goes on as before";
    wait_until_told("Screenshot: ");
    const std::string first = last_notice();
    tap(function_key(12));
    for (int i = 0; i < 1000 && last_notice() == first; ++i) frames(1);
    ASSERT_EQ(screenshots().size(), 2u);
    for (const auto& file : screenshots()) {
        const auto texels = render::read_png(file, 3);
        ASSERT_TRUE(texels) << texels.error();
        ASSERT_EQ(texels->width, 640);
        ASSERT_EQ(texels->height, 360);
        bool equal = true;
        for (std::size_t y = 0; y < 360; ++y)  // texels begin with the lowest row
            equal &= std::equal(world.pixels.begin() + 1920 * y, world.pixels.begin() + 1920 * (y + 1),
                                texels->values.begin() + 1920 * (359 - y));
        EXPECT_TRUE(equal) << file;
    }
}

// F8: the world stands still while camera, lens and light move; afterwards all is as before.
TEST_F(Sending, takes_photos_in_a_world_that_stands_still_and_gives_everything_back) {
    begin();
    const render::Camera camera = app_->camera();
    const Display display = app_->display();
    tap(function_key(8));
    frames(2);
    ASSERT_TRUE(app_->photo().is_on());
    const StateLine before = line();
    frames(4);
    EXPECT_EQ(line(), before) << "time stands still, though it is not paused";
    EXPECT_EQ(app_->camera(), camera) << "the first lens is that of the camera";
    EXPECT_TRUE(shows("Photo bar"));
    for (const char* label : {"Pour", "Pause"}) EXPECT_FALSE(shows(label)) << label;
    stroke(2);
    tap(key('Z'), {false, true, false});
    tap(key('2'));
    EXPECT_EQ(line(), before) << "no tool, no key changes anything";
    EXPECT_EQ(app_->brush().tool, Tool::kPour);

    click("Exposure");
    click("Focal length");
    click("Time of day");
    click("Depth of field");
    click("2 ×");
    const PhotoSettings settings = app_->photo().settings();
    EXPECT_NEAR(app_->camera().field_of_view_deg, field_of_view_of(settings.focal_mm, 640.0 / 360), 1e-9);
    EXPECT_NE(app_->camera().field_of_view_deg, camera.field_of_view_deg);
    ASSERT_TRUE(settings.hour);
    ASSERT_GT(settings.f_number, 0);
    const double focus_m = app_->photo().focus_m(app_->camera());
    screen_.move(kAtX, kAtY - 60);
    screen_.press(Button::kLeft);
    frames(2);
    screen_.release(Button::kLeft);
    frames(2);
    EXPECT_NE(app_->photo().focus_m(app_->camera()), focus_m) << "on what is clicked at";
    EXPECT_EQ(line(), before);
    EXPECT_EQ(app_->display(), display) << "the light of the window does not change";
    click("Take the photo");
    wait_until_told("Screenshot: ");
    const std::string first = last_notice();
    tap(Key::kEnter);
    for (int i = 0; i < 1000 && last_notice() == first; ++i) frames(1);
    ASSERT_EQ(screenshots().size(), 2u);
    for (const auto& file : screenshots()) {
        const auto texels = render::read_png(file, 3);
        ASSERT_TRUE(texels) << texels.error();
        EXPECT_EQ(texels->width, 1280);
        EXPECT_EQ(texels->height, 720);
    }
    EXPECT_EQ(line(), before);

    tap(Key::kEscape);
    EXPECT_FALSE(app_->photo().is_on());
    EXPECT_FALSE(app_->panels().shows_menu());
    EXPECT_EQ(app_->camera().field_of_view_deg, camera.field_of_view_deg);
    EXPECT_EQ(app_->display(), display);
    EXPECT_FALSE(app_->clock().paused()) << "as before";
    tap(function_key(8));
    tap(function_key(8));
    EXPECT_FALSE(app_->photo().is_on());
}

// The window goes on with the image that it had: the bar fills, and Esc ends the photo alone.
TEST_F(Sending, draws_a_large_photo_a_part_per_frame_and_stops_it_if_asked) {
    begin();
    tap(function_key(8));
    frames(2);
    click("2 ×");
    screen_.move(kAtX, 20);
    frames(60);
    const auto sky_and_slope = [this] {
        const render::Picture picture = screen_.picture();
        return std::vector<std::uint8_t>(picture.pixels.begin(), picture.pixels.begin() + 3 * 640 * 200);
    };
    const auto before = sky_and_slope();
    const render::Camera camera = app_->camera();
    const WorldImage& image = app_->image();
    tap(Key::kEnter);
    EXPECT_EQ(image.photo_progress(), 0);
    screen_.happen({WheelEvent{5, {}}});
    tap(Key::kHome);
    ASSERT_GT(image.photo_progress(), 0);
    EXPECT_LT(image.photo_progress(), 1);
    EXPECT_TRUE(sky_and_slope() == before);
    EXPECT_TRUE(shows("Taking the photo"));
    EXPECT_EQ(app_->camera(), camera) << "nothing moves meanwhile";
    tap(Key::kEscape);
    EXPECT_FALSE(image.photo_progress());
    EXPECT_TRUE(app_->photo().is_on());
    EXPECT_NE(last_notice().find("stopped"), std::string::npos) << last_notice();
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "couloir/screenshots"));
    EXPECT_EQ(app_->camera(), camera);
    frames(400);  // until no notice is shown
    EXPECT_TRUE(sky_and_slope() == before);

    tap(Key::kEnter);
    int parts = 0;
    for (; image.photo_progress() && parts < 100; ++parts) frames(1);
    EXPECT_GE(parts, 4);
    EXPECT_TRUE(sky_and_slope() == before);
    wait_until_told("Screenshot: ");
    EXPECT_EQ(screenshots().size(), 1u);

    tap(Key::kEnter);
    frames(1);
    ASSERT_TRUE(image.photo_progress());
    screen_.drop({"landslide"});
    frames(2);
    EXPECT_FALSE(image.photo_progress());
    EXPECT_FALSE(app_->photo().is_on());
}

TEST_F(Sending, says_that_a_photo_cannot_be_written_or_is_too_large) {
    begin();
    std::filesystem::create_directory(folder_.path() / "couloir");
    std::ofstream(folder_.path() / "couloir/screenshots") << "a file";
    tap(function_key(8));
    tap(function_key(12));
    wait_until_told("No screenshot: ");
    EXPECT_NE(last_notice().find("couloir/screenshots"), std::string::npos) << last_notice();
    click("4 ×");
    screen_.limit_side(64);
    tap(Key::kEnter);
    wait_until_told("2560×1440");
    EXPECT_TRUE(app_->photo().is_on());
}

TEST_F(Sending, leaves_the_photo_mode_with_its_world) {
    begin();
    const double before = app_->camera().field_of_view_deg;
    tap(function_key(8));
    frames(2);
    click("Focal length");
    EXPECT_NE(app_->camera().field_of_view_deg, before);
    screen_.drop({"landslide"});
    frames(2);
    EXPECT_FALSE(app_->photo().is_on());
}

TEST_F(Sending, says_that_a_screenshot_cannot_be_written) {
    begin();
    std::filesystem::create_directory(folder_.path() / "couloir");
    std::ofstream(folder_.path() / "couloir/screenshots") << "a file";
    tap(function_key(12));
    wait_until_told("No screenshot: ");
    EXPECT_NE(last_notice().find("couloir/screenshots"), std::string::npos) << last_notice();
}

TEST_F(Sending, shares_page_and_recording_and_opens_their_folder) {
    begin();
    stroke(30);
    const auto own = *app_->recording();
    const std::int64_t tick = state().tick;
    tap(Key::kSpace);
    tap(function_key(10));
    EXPECT_TRUE(app_->is_sharing());
    tap(function_key(10));
    EXPECT_NE(last_notice().find("is being shared"), std::string::npos) << last_notice();
    wait_until_told("Shared: ");
    ASSERT_EQ(shared().size(), 1u);
    EXPECT_NE(last_notice().find(shared()[0].string()), std::string::npos) << last_notice();
    EXPECT_EQ(shared()[0].filename().string().rfind("alpine-valley-", 0), 0u);
    const auto recording = read_recording(shared()[0] / "slide.couloir");
    ASSERT_TRUE(recording) << recording.error().sentence;
    EXPECT_FALSE(recording->warning);
    EXPECT_GE(recording->last_tick(), tick);
    EXPECT_GT(std::filesystem::file_size(shared()[0] / "slide.html"), 0u);
    wait_until([&] { return std::filesystem::exists(opened()); });
    EXPECT_TRUE(std::filesystem::exists(opened()));
    EXPECT_EQ(*app_->recording(), own);
    tap(Key::kSpace);
    expect_recording_replays();
}

TEST_F(Sending, shares_a_lesson_as_a_page_that_gives_it) {
    auto loaded = open_lesson("where-will-it-stop", {});
    ASSERT_TRUE(loaded) << loaded.error().sentence;
    auto begun = App::begin(screen_, std::move(*loaded), sim::StepOptions{}, std::nullopt, tier_);
    ASSERT_TRUE(begun) << begun.error().sentence;
    app_ = std::move(*begun);
    frames(2);
    tap(function_key(10));
    EXPECT_TRUE(app_->is_sharing());
    wait_until([&] { return !shared().empty() && std::filesystem::exists(shared()[0] / "slide.html"); });
    wait_until_told("Shared: ");
    ASSERT_EQ(shared().size(), 1u);
    const auto page = read_text(shared()[0] / "slide.html");
    ASSERT_TRUE(page);
    EXPECT_NE(page->find("It ran 1528 m in plan"), std::string::npos);
}

TEST_F(Sending, shares_a_challenge_in_which_nothing_was_done_as_one_to_play) {
    begin("one-shovel", 40);
    tap(function_key(10));
    EXPECT_TRUE(app_->is_sharing());
    wait_until_told("Shared: ");
    ASSERT_EQ(shared().size(), 1u);
    const auto world = read_recording(shared()[0] / "slide.couloir");
    ASSERT_TRUE(world) << world.error().sentence;
    EXPECT_TRUE(is_world(*world));
    EXPECT_EQ(challenge_id(world->header.scenario), challenge_id(app_->sandbox().scenario()));
    std::ifstream page(shared()[0] / "slide.html");
    const std::string text(std::istreambuf_iterator<char>(page), {});
    EXPECT_NE(text.find("Make it run as far as you can"), std::string::npos);
}

TEST_F(Sending, says_why_there_is_nothing_to_share) {
    begin("winter-valley", 40);
    tap(function_key(10));
    EXPECT_NE(last_notice().find("Nothing to share"), std::string::npos) << last_notice();
    app_.reset();
    begin("flow-disc", 0);
    tap(function_key(10));
    EXPECT_NE(last_notice().find("flow demo"), std::string::npos) << last_notice();
    EXPECT_TRUE(shared().empty());
    app_.reset();
    begin();
    stroke(5);
    std::filesystem::create_directory(folder_.path() / "couloir");
    std::ofstream(folder_.path() / "couloir/shared") << "a file";
    tap(function_key(10));
    wait_until_told("was not shared: ");
    EXPECT_NE(last_notice().find("couloir/shared"), std::string::npos) << last_notice();
}

TEST_F(Sending, shares_nothing_for_which_there_is_no_memory) {
    begin();
    wishes_.memory.most = expected_bytes(state().grid, false, {});
    app_.reset();
    begin();
    stroke(5);
    tap(function_key(10));
    EXPECT_FALSE(app_->is_sharing());
    EXPECT_NE(last_notice().find("--max-memory"), std::string::npos) << last_notice();
}

TEST_F(Sending, leaves_nothing_of_a_slide_if_it_quits_meanwhile) {
    begin();
    stroke(60);
    tap(function_key(10));
    ASSERT_TRUE(app_->is_sharing());
    EXPECT_TRUE(app_->finish());
    app_.reset();
    EXPECT_TRUE(shared().empty());
}

TEST_F(Sending, says_that_a_slide_has_come_to_rest_and_how_to_share_it) {
    begin("alpine-valley", 40);
    stroke(20);
    for (int i = 0; i < 4; ++i) tap(Key::kEqual);
    screen_.resize_to(160, 90);
    wait_until_told("come to rest");
    EXPECT_NE(last_notice().find("F10"), std::string::npos) << last_notice();
}

// An ensemble over its world.
class PlayingAnEnsemble : public Playing {
  protected:
    void begin_ensemble() {
        const std::filesystem::path spec = folder_.path() / "spec.toml", out = folder_.path() / "out";
        std::ofstream(spec) << "scene = \"landslide\"\ngrid = 20\nseconds = 30\nmembers = 6\n"
                               "[[variable]]\nof = \"friction\"\nuniform = [0.1, 0.4]\n"
                               "[[map]]\nof = \"thickness\"\nover = [0.1, 1]\n";
        const auto read = read_ensemble_spec(spec, {});
        ASSERT_TRUE(read) << read.error().sentence;
        ASSERT_TRUE(run_ensemble(*read, out, 2));
        auto shown = runs_of_ensemble(spec, out, {});
        ASSERT_TRUE(shown) << shown.error().sentence;
        auto begun = App::begin(screen_, shown->world, sim::StepOptions{}, std::nullopt, tier_);
        ASSERT_TRUE(begun) << begun.error().sentence;
        app_ = std::move(*begun);
        app_->show_runs(std::move(*shown));
        frames(3);
    }
    ui::RunsNote note() const { return app_->runs()->note(std::nullopt); }
};

TEST_F(PlayingAnEnsemble, opens_the_run_whose_end_is_clicked) {
    screen_.resize_to(1280, 720);
    begin_ensemble();
    EXPECT_EQ(app_->display().overlay, render::Overlay::kProbability);
    EXPECT_TRUE(app_->clock().paused());
    EXPECT_EQ(note().maps, 2u);
    std::size_t runs = 0;
    for (const ui::RunEnd& end : note().ends) runs += end.runs;
    EXPECT_EQ(runs, 6u) << "all ends are in view when it is opened";
    const glm::dvec2 at = note().ends.front().at;
    EXPECT_LT(at.y, 620) << "above the time bar";
    screen_.move(at.x, at.y);
    frames(2);
    ASSERT_TRUE(note().under);
    EXPECT_NE(note().under->words.find("Click: run"), std::string_view::npos) << note().under->words;
    const auto picture = screen_.picture();
    screen_.press(Button::kLeft);
    frames(1);
    screen_.release(Button::kLeft);
    frames(2);

    const std::string& title = app_->sandbox().scenario().title;
    ASSERT_NE(title.find("member "), std::string::npos) << title;
    const std::int64_t number = std::stoll(title.substr(title.find("member ") + 7));
    const auto read = read_ensemble_spec(folder_.path() / "spec.toml", {});
    EXPECT_FLOAT_EQ(app_->sandbox().scenario().params.friction, static_cast<float>(read->sample(number)[0]));
    EXPECT_EQ(app_->display().overlay, render::Overlay::kNone);
    EXPECT_FALSE(app_->clock().paused());
    EXPECT_TRUE(std::ranges::any_of(note().ends, &ui::RunEnd::is_open));
    EXPECT_NE(screen_.picture().pixels, picture.pixels);
    // What it comes to is what the journal says of it.
    const auto result = read_ensemble(*read, folder_.path() / "out");
    ASSERT_TRUE(result);
    auto session = Session::begin(app_->sandbox().scenario(), {}, std::nullopt);
    Until until;
    until.rest = Until::Rest::kEnergy;
    until.most_ticks = 30 * 60;
    ASSERT_TRUE(play_headless(*session, read->scene.commands, until, {}, ""));
    EXPECT_EQ(hex(session->state_line().hash), result->members.at(number).hash);
}

TEST_F(PlayingAnEnsemble, shows_it_until_a_world_on_other_ground_is_opened) {
    screen_.resize_to(1280, 720);
    begin_ensemble();
    const auto with_ends = screen_.picture();
    click("End points");
    EXPECT_FALSE(app_->display().ends);
    screen_.move(1270, 300);
    frames(2);
    EXPECT_NE(screen_.picture().pixels, with_ends.pixels);
    screen_.drop({support::source_dir() / "assets/scenes/landslide.toml"});  // as fine as the scene has it
    frames(2);
    EXPECT_FALSE(app_->runs());
    EXPECT_EQ(app_->sandbox().scenario().scene, "landslide");
}

}  // namespace
}  // namespace game
