// The page of a slide, as the program writes it. tests/web opens it in a browser.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <new>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/analysis/headless.h"
#include "game/recording/base64.h"
#include "game/scene/scene.h"
#include "game/scene/viewpoint.h"
#include "game/share/in_order.h"
#include "game/share/sha256.h"
#include "game/share/share_recording.h"
#include "game/share/slide_page.h"
#include "render/mountain/drawn_mixture.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/game/unpacked_page.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

// The fields of a tick that a page keeps.
struct Fields {
    std::vector<float> depth, rolling, speed;
    std::vector<std::uint8_t> mixture;

    explicit Fields(const sim::View& world) {
        for (int y = 0; y < world.grid.ny; ++y)
            for (int x = 0; x < world.grid.nx; ++x) {
                depth.push_back(world.depth(x, y));
                rolling.push_back(world.rolling(x, y));
                speed.push_back(world.rolling(x, y) >= Peaks::kVisible
                                    ? std::hypot(world.velocity_x(x, y), world.velocity_y(x, y))
                                    : 0);
            }
        render::drawn_mixture(world, mixture);
    }
};

class SlidePages : public testing::Test {
  protected:
    Scene scene_of(const char* name, int squares = 32) {
        Overrides overrides;
        overrides.squares = squares;
        return load_scene(name, overrides).value();
    }

    // Plays a scene and writes its page. Keeps all its ticks in `ticks`, if that is given.
    Outcome<PageReport> write(const Scene& scene, std::int64_t last, const PageOptions& options = {},
                              std::vector<Fields>* ticks = nullptr, const sim::StepOptions& step = {}) {
        auto session = Session::begin(scene.scenario, step, std::nullopt);
        if (!session) return tl::unexpected(session.error());
        session->follow_powder(scene.scenario);
        auto page = SlidePage::begin(scene.scenario, *session, "couloir replay it --verify", options);
        if (!page) return tl::unexpected(page.error());
        if (ticks) ticks->emplace_back(session->view());
        Watchers watchers;
        watchers.keep = [&](const Session& now) {
            if (ticks) ticks->emplace_back(now.view());
            return page->see(now);
        };
        auto played = play_headless(*session, scene.commands, Until::after(last), watchers, "playing");
        if (!played) return tl::unexpected(played.error());
        hash_ = hex(session->state_line().hash);
        return page->write(file(), *session, scene.commands);
    }

    fs::path file() const { return folder_.path() / "slide.html"; }
    UnpackedPage page() const { return UnpackedPage(read_bytes(file())); }

    support::TemporaryFolder folder_;
    std::string hash_;
};

void expect_kept(const UnpackedPage& page, const std::vector<Fields>& ticks) {
    const int nx = page.info()["grid"]["nx"], ny = page.info()["grid"]["ny"];
    const std::int64_t every = page.info()["every"], last = page.info()["last"],
                       frames = page.info()["frames"];
    EXPECT_EQ(last + 1, std::ssize(ticks));
    EXPECT_EQ(frames, (last + every - 1) / every + 1);
    EXPECT_EQ(std::ssize(page.info()["volume"]), frames);
    const auto first = [&](const char* name, const char* array) {
        std::vector<std::uint16_t> whole(static_cast<std::size_t>(nx * ny));
        if (!array) return whole;
        const double step = page.info()["moving"][name]["step"];
        const std::vector<double> values = page.array(array);
        for (std::size_t i = 0; i < whole.size(); ++i)
            whole[i] = static_cast<std::uint16_t>(std::lround(values[i] / step));
        return whole;
    };
    for (std::int64_t frame = 0; frame < frames; frame += frame + 2 < frames ? 7 : 1) {
        const Fields& now = ticks[static_cast<std::size_t>(std::min(frame * every, last))];
        const auto expect_near = [&](const char* name, const char* array, auto&& value, double error) {
            const double step = page.info()["moving"][name]["step"];
            const auto kept = page.moving(name, nx, ny, frame, first(name, array));
            for (std::size_t i = 0; i < kept.size(); ++i)
                ASSERT_NEAR(kept[i] * step, static_cast<double>(value(i)), error)
                    << name << " at " << i << " in " << frame;
        };
        const Json& error = page.info()["error"];
        expect_near(
            "d", "d0", [&](std::size_t i) { return now.depth[i]; }, error["depth"]);
        expect_near(
            "R", nullptr, [&](std::size_t i) { return now.rolling[i]; }, error["moving"]);
        expect_near(
            "s", nullptr, [&](std::size_t i) { return now.speed[i]; }, error["speed"]);
        if (!page.info()["two"]) continue;
        expect_near(
            "lower_d", "lower0", [&](std::size_t i) { return now.mixture[2 * i] / 255.0; }, 1e-9);
        expect_near(
            "lower_R", nullptr, [&](std::size_t i) { return now.mixture[2 * i + 1] / 255.0; }, 1e-9);
    }
    EXPECT_LE(page.info()["error"]["depth"], 0.0052);
    EXPECT_LE(page.info()["error"]["speed"], 0.064);
}

sim::Command sculpting() {
    sim::Command sculpt;
    sculpt.kind = sim::CommandKind::kSculpt;
    sculpt.x = sculpt.y = 100, sculpt.radius = 20, sculpt.rise = 2;
    return sculpt;
}
sim::Command planting() {
    sim::Command plant;
    plant.kind = sim::CommandKind::kPlant;
    plant.x = plant.y = 100, plant.radius = 20;
    plant.stems = 400, plant.diameter = 0.3, plant.height = 22;
    return plant;
}

TEST_F(SlidePages, are_refused_where_ground_is_sculpted_or_forest_planted_during_the_slide) {
    for (const auto& [command, what] :
         {std::pair(sculpting(), "sculpted during"), std::pair(planting(), "planted during")}) {
        Scene scene = scene_of("landslide");
        scene.commands = {{12, command}};
        const auto refused = write(scene, 30);
        ASSERT_FALSE(refused) << what;
        EXPECT_EQ(refused.error().status, Failure::kUnusable);
        EXPECT_NE(refused.error().sentence.find(what), std::string::npos) << refused.error().sentence;
    }
}

TEST_F(SlidePages, have_the_ground_and_the_forest_that_people_have_made_before) {
    Scene scene = scene_of("landslide");
    scene.scenario.standing.placed = {sculpting(), planting()};
    ASSERT_TRUE(write(scene, 30));
    const auto session = Session::begin(scene.scenario, {}, std::nullopt).value();
    const sim::Things& things = *session.state().things;
    const UnpackedPage page = this->page();
    const std::vector<double> bed = page.array("bed"), earth = page.array("earth"),
                              on = page.array("trees.on"), east = page.array("trees.x"),
                              north = page.array("trees.y");
    const double near = page.info()["error"]["ground"].get<double>() + 1e-9;
    double raised = 0;
    for (int y = 0, i = 0; y < session.state().grid.ny; ++y)
        for (int x = 0; x < session.state().grid.nx; ++x, ++i) {
            ASSERT_NEAR(earth[i], things.earth(x, y), near);
            ASSERT_NEAR(bed[i], session.state().bedrock(x, y), near);
            raised += earth[i];
        }
    EXPECT_GT(raised, 1);
    ASSERT_GT(on.size(), 10u);
    for (std::size_t i = 0; i < on.size(); ++i) {
        EXPECT_EQ(on[i], 2) << "by the forest";
        EXPECT_LT(std::hypot(east[i] - 100, north[i] - 100),
                  20 + static_cast<double>(session.state().grid.dx));
    }
    scene.scenario.standing.placed.clear();
    ASSERT_TRUE(write(scene, 30));
    EXPECT_FALSE(this->page().has("earth.0"));
}

TEST_F(SlidePages, keep_every_state_within_the_error_that_they_name) {
    std::vector<Fields> ticks;
    const auto report = write(scene_of("landslide"), 400, {}, &ticks);
    ASSERT_TRUE(report) << report.error().sentence;
    EXPECT_EQ(report->bytes, fs::file_size(file()));
    const UnpackedPage page = this->page();
    expect_kept(page, ticks);
    EXPECT_EQ(page.info()["hash"], hash_);
    EXPECT_EQ(page.info()["command"], "couloir replay it --verify");
    EXPECT_FALSE(page.info()["two"]);
}

TEST_F(SlidePages, keep_two_materials) {
    std::vector<Fields> ticks;
    ASSERT_TRUE(write(scene_of("snow-on-soil"), 240, {}, &ticks));
    expect_kept(page(), ticks);
    EXPECT_TRUE(page().info()["two"]);
}

TEST_F(SlidePages, end_in_the_last_state_whatever_the_interval) {
    for (const std::int64_t every : {1, 7, 100, 1000}) {
        std::vector<Fields> ticks;
        ASSERT_TRUE(write(scene_of("landslide", 16), 101, {.every = every}, &ticks));
        expect_kept(page(), ticks);
    }
}

TEST_F(SlidePages, are_the_same_bytes_for_the_same_slide) {
    const Scene scene = scene_of("snow-avalanche");
    ASSERT_TRUE(write(scene, 300));
    const std::string once = read_bytes(file());
    ASSERT_TRUE(write(scene, 300, {}, nullptr, {.threads = 3}));
    EXPECT_TRUE(read_bytes(file()) == once);
}

TEST_F(SlidePages, carry_trees_in_leaf_if_a_day_of_the_year_is_stated) {
    Scene scene = scene_of("winter-avalanche");
    scene.scenario.look.date = render::Date{7, 15};
    ASSERT_TRUE(write(scene, 1, {.plays = false}));
    const UnpackedPage page = this->page();
    EXPECT_EQ(page.array("trees.in_leaf").size(), page.array("trees.pictures").size());
    const std::vector<double> kinds = page.array("trees.kind");
    for (const auto kind : {render::TreeKind::kBeech, render::TreeKind::kBirch, render::TreeKind::kBush})
        EXPECT_GT(std::ranges::count(kinds, static_cast<double>(kind)), 10);
}

TEST_F(SlidePages, have_peaks_woods_and_puffs_as_the_program_has) {
    const Scene scene = scene_of("winter-avalanche", 48);
    ASSERT_TRUE(write(scene, 2700));
    const UnpackedPage page = this->page();
    EXPECT_FALSE(page.info()["arrays"].contains("trees.in_leaf")) << "no day of the year is stated";
    const auto trees = static_cast<std::size_t>(page.info()["arrays"]["trees.x"]["size"][0]);
    EXPECT_GT(trees, 1000u);
    double counted = 0;
    for (const double count : page.array("trees.count")) counted += count;
    EXPECT_EQ(counted, static_cast<double>(trees));
    const std::int64_t frames = page.info()["frames"];
    std::size_t fallen = 0;
    for (const double frame : page.array("trees.falls")) fallen += frame < static_cast<double>(frames);
    EXPECT_GT(fallen, 0u);
    EXPECT_LT(fallen, trees / 2);
    const std::vector<double> born = page.array("puffs.born");
    EXPECT_GT(born.size(), 100u);
    EXPECT_TRUE(std::is_sorted(born.begin(), born.end()));
    // A hut that is hit has one piece before and one after.
    const std::vector<double> from = page.array("built.from"), until = page.array("built.until"),
                              first = page.array("built.first"), count = page.array("built.count");
    ASSERT_FALSE(from.empty());
    for (std::size_t i = 0; i < from.size(); ++i) {
        EXPECT_LT(from[i], until[i]);
        EXPECT_LE(first[i] + count[i], static_cast<double>(page.array("built.x").size()));
    }
    const std::vector<double> speed = page.array("peak_speed");
    EXPECT_NEAR(*std::max_element(speed.begin(), speed.end()),
                page.info()["measures"]["peak_speed_plan_m_s"].get<double>(), 0.07);
}

TEST_F(SlidePages, of_a_block_have_no_mountains_around) {
    Scene scene = scene_of("landslide", 16);
    scene.scenario.model = true;
    ASSERT_TRUE(write(scene, 12));
    EXPECT_FALSE(page().info()["surroundings"]);
    EXPECT_FALSE(page().has("around.x.0"));
}

TEST_F(SlidePages, carry_every_shader_that_their_program_names_and_nothing_of_this_machine) {
    ASSERT_TRUE(write(scene_of("landslide", 16), 12));
    const std::string html = read_bytes(file());
    const Json shaders = Json::parse(page().part("files"));
    EXPECT_GT(shaders.size(), 20u);
    for (const auto& [name, text] : shaders.items()) {
        EXPECT_NE(html.find("'" + name + "'"), std::string::npos) << name;
        EXPECT_FALSE(text.get<std::string>().empty()) << name;
    }
    for (const std::string& place : {support::source_dir().string(), folder_.path().string()})
        EXPECT_EQ(html.find(place), std::string::npos) << place;
    EXPECT_EQ(html.find("http://"), std::string::npos);
    EXPECT_EQ(html.find("https://"), std::string::npos);
}

TEST_F(SlidePages, show_any_title_as_it_is) {
    Scene scene = scene_of("landslide", 16);
    scene.scenario.title = "</script><script>alert(1)</script> & \"more\" @FIELDS@ \xff";
    scene.scenario.licence = "© Geländedaten, 数据 <b>";
    ASSERT_TRUE(write(scene, 6));
    const std::string html = read_bytes(file());
    EXPECT_EQ(html.find("<script>alert"), std::string::npos);
    EXPECT_EQ(page().info()["title"], "</script><script>alert(1)</script> & \"more\" @FIELDS@ \uFFFD");
    EXPECT_EQ(page().info()["licence"], scene.scenario.licence);
}

// FIPS 180-4 and lengths about the end of a block; expected values from coreutils' sha256sum.
TEST(Sha256, is_that_of_the_standard) {
    const auto digest = [](const std::string& bytes) {
        std::string text;
        for (const std::uint8_t byte : sha256(bytes)) text += fmt::format("{:02x}", byte);
        return text;
    };
    EXPECT_EQ(digest(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(digest("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(digest(std::string(55, 'y')),
              "fb66d40c3bfff05b0d5af8612d0abfbfacc6f5f26c330bc7ad634f1f44bc20ad");
    EXPECT_EQ(digest(std::string(56, 'y')),
              "4877e564e5e36e367c7c8d59670774becd3350610b6df4c399c9fa9b66da5813");
    EXPECT_EQ(digest(std::string(64, 'x')),
              "7ce100971f64e7001e8fe5a51973ecdfe1ced42befe7ee8d5fd6219506b5393c");
    EXPECT_EQ(digest(std::string(1'000'000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_F(SlidePages, let_only_their_own_scripts_run) {
    Scene scene = scene_of("landslide", 16);
    scene.scenario.title = "<script>alert(1)</script>";
    for (const bool plays : {false, true}) {
        ASSERT_TRUE(write(scene, 6, {.plays = plays}));
        const std::string html = read_bytes(file());
        const std::string begin = "http-equiv=\"Content-Security-Policy\" content=\"";
        const auto at = html.find(begin) + begin.size();
        const std::string policy = html.substr(at, html.find('"', at) - at);
        for (const char* rule : {"default-src 'none'", "base-uri 'none'", "form-action 'none'"})
            EXPECT_NE(policy.find(rule), std::string::npos) << policy;
        const auto scripts = policy.find("script-src "), end = policy.find(';', scripts);
        std::string expected = "script-src";
        for (auto from = html.find("<script>"); from != std::string::npos;
             from = html.find("<script>", from)) {
            from += std::string("<script>").size();
            const auto digest = sha256(html.substr(from, html.find("</script>", from) - from));
            expected += " 'sha256-" + to_base64(std::string(digest.begin(), digest.end())) + "'";
        }
        EXPECT_EQ(std::count(expected.begin(), expected.end(), ' '), 2);
        // A world needs its module, and a thread made from the page's own text.
        if (plays) expected += " 'wasm-unsafe-eval'";
        EXPECT_EQ(policy.substr(scripts, end - scripts), expected);
        EXPECT_EQ(policy.find("worker-src blob:;") != std::string::npos, plays) << policy;
    }
}

TEST_F(SlidePages, that_are_too_large_are_refused_and_not_written) {
    for (const std::uint64_t most : {1'000u, 300'000u}) {
        const auto refused = write(scene_of("winter-avalanche", 48), 1000, {.most_bytes = most});
        ASSERT_FALSE(refused) << most;
        EXPECT_EQ(refused.error().status, Failure::kUnusable);
        EXPECT_NE(refused.error().sentence.find("Use a larger --every or --size-limit"), std::string::npos)
            << refused.error().sentence;
        EXPECT_NE(refused.error().sentence.find(most == 1'000 ? "1.0 kB" : "300.0 kB"), std::string::npos)
            << refused.error().sentence;
        EXPECT_FALSE(fs::exists(file()));
    }
}

TEST_F(SlidePages, of_flow_scenes_are_refused) {
    const auto refused = write(load_scene("flow-disc", {}).value(), 6);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence.find("flow-disc"), std::string::npos) << refused.error().sentence;
}

TEST_F(SlidePages, refuse_a_depth_that_they_cannot_keep) {
    Scene scene = scene_of("landslide", 16);
    scene.scenario.depth[40] = 700;
    const auto refused = write(scene, 6);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence.find("a depth, m of 700; a page keeps 0 to 655.35"), std::string::npos)
        << refused.error().sentence;
}

TEST_F(SlidePages, of_a_recording_are_those_of_the_command_line) {
    const fs::path recording = folder_.path() / "a b.couloir";
    record(recording, small_scenario(), 40, some_commands());
    ASSERT_EQ(couloir({"replay", recording.string(), "--web", (folder_.path() / "one.html").string()}).status,
              0);
    std::atomic<float> progress = 0;
    const auto report = write_page_of(recording, file(), {}, nullptr, &progress);
    ASSERT_TRUE(report) << report.error().sentence;
    EXPECT_TRUE(read_bytes(file()) == read_bytes(folder_.path() / "one.html"));
    EXPECT_GT(progress, 0.9f);
    EXPECT_EQ(page().info()["command"], "couloir replay 'a b.couloir' --verify");

    EXPECT_EQ(proof_of("landslide"), "couloir replay landslide --verify");
    EXPECT_EQ(proof_of("/home/me/it's mine.couloir"), R"(couloir replay 'it'\''s mine.couloir' --verify)");
    fs::remove(file());
    const std::atomic<bool> stop = true;
    EXPECT_FALSE(write_page_of(recording, file(), {}, &stop, nullptr));
    EXPECT_FALSE(fs::exists(file()));
    const Finished same = couloir({"replay", recording.string(), "--web", recording.string()});
    EXPECT_EQ(same.status, 2);
    EXPECT_NE(same.err.find("--web"), std::string::npos) << same.err;
}

TEST(PagePacking, does_its_work_in_order_and_none_after_a_failure) {
    std::vector<int> done;
    InOrder packing(2);
    for (int i = 0; i < 20; ++i)
        ASSERT_TRUE(packing.give([&done, i]() -> Outcome<void> {
            done.push_back(i);
            return {};
        }));
    ASSERT_TRUE(packing.finish());
    ASSERT_EQ(done.size(), 20u);
    EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));

    ASSERT_TRUE(packing.give([]() -> Outcome<void> { throw std::bad_alloc(); }));
    const auto failed = packing.finish();
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().status, Failure::kMachine);
    EXPECT_FALSE(packing.give([&done]() -> Outcome<void> {
        done.clear();
        return {};
    }));
    EXPECT_EQ(done.size(), 20u);
}

TEST(PagePacking, ends_while_work_waits) {
    std::atomic<int> done = 0;
    {
        InOrder packing(8);
        for (int i = 0; i < 8; ++i)
            ASSERT_TRUE(packing.give([&done]() -> Outcome<void> {
                ++done;
                return {};
            }));
    }
    EXPECT_LE(done, 8);
}

TEST(Viewpoint, is_five_numbers_in_their_ranges) {
    const auto failure_of = [](const std::string& text) {
        const Finished finished = couloir({"replay", "landslide", "--until", "0", "--camera", text});
        EXPECT_TRUE(finished.status == 0 || finished.err.find("--camera") != std::string::npos)
            << finished.err;
        return finished.status;
    };
    EXPECT_EQ(failure_of("40,40,-90,2,1"), 0);
    EXPECT_EQ(failure_of("0,0,360,89,1e6"), 0);
    for (const char* wrong :
         {"", "1", "1,2,3,4", "1,2,3,4,5,6", "40,40,90,10,", ",40,90,10,300", "40,40,361,10,300",
          "40,40,90,1.9,300", "40,40,90,89.5,300", "40,40,90,10,0.5", "40,40,90,10,2e6", "-1,40,90,10,300",
          "40,nan,90,10,300", "40,40,90,10,0x10", "1e6,40,90,10,300"})
        EXPECT_EQ(failure_of(wrong), 2) << wrong;
}

TEST(Viewpoint, looks_at_the_surface) {
    Scenario scenario = small_scenario();
    ASSERT_TRUE(look_from({2 * static_cast<double>(scenario.grid.dx), 0, 10, 20, 30}, scenario));
    EXPECT_EQ(scenario.camera->target.z, scenario.datum + static_cast<double>(scenario.bedrock[2]) +
                                             static_cast<double>(scenario.depth[2]));
    EXPECT_EQ(scenario.camera->elevation_deg, 20);
    const auto outside = look_from({1e5, 0, 10, 20, 30}, scenario);
    ASSERT_FALSE(outside);
    EXPECT_NE(outside.error().sentence.find("is outside the terrain of"), std::string::npos)
        << outside.error().sentence;
}

}  // namespace
}  // namespace game::test
