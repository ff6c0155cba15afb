// Camera paths: how a camera moves between keys, and how keys are written and read.
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/base/limits.h"
#include "game/controls/camera_room.h"
#include "game/controls/camera_spline.h"
#include "game/controls/film_camera.h"
#include "game/controls/path_maker.h"
#include "game/recording/recording_file.h"
#include "game/scene/camera_keys.h"
#include "game/scene/scene.h"
#include "game/session/session.h"
#include "game/session/world_now.h"
#include "render/mountain/overview.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

CameraKey key(double time, glm::dvec3 target, double azimuth, double elevation, double distance) {
    return {time, {target, azimuth, elevation, distance, 40}};
}

const std::vector<CameraKey> kKeys{key(2, {0, 0, 100}, 350, 20, 1000), key(5, {200, 50, 80}, 20, 30, 500),
                                   key(6, {210, 80, 60}, 100, 30, 500),
                                   key(11, {150, 400, 10}, 300, 10, 900)};

std::vector<double> values_of(const render::Camera& camera) {
    return {camera.target.x,      camera.target.y,   camera.target.z,         camera.azimuth_deg,
            camera.elevation_deg, camera.distance_m, camera.field_of_view_deg};
}

TEST(CameraSpline, passes_its_keys_and_stands_before_and_after_them) {
    const CameraSpline spline(kKeys);
    EXPECT_EQ(spline.begins_s(), 2);
    EXPECT_EQ(spline.ends_s(), 11);
    for (const CameraKey& each : kKeys) {
        const render::Camera at = spline.at(each.time_s);
        EXPECT_NEAR(glm::distance(render::eye(at), render::eye(each.camera)), 0, 1e-9);
        EXPECT_NEAR(at.field_of_view_deg, 40, 1e-9);
    }
    EXPECT_EQ(spline.at(-1e5), spline.at(2));
    EXPECT_EQ(spline.at(1e5), spline.at(11));
    const CameraSpline alone({kKeys.data(), 1});
    EXPECT_EQ(alone.at(0), alone.at(100));
}

TEST(CameraSpline, never_leaves_the_range_of_the_keys_beside_it_and_turns_the_short_way) {
    const CameraSpline spline(kKeys);
    for (std::size_t k = 0; k + 1 < kKeys.size(); ++k) {
        const auto from = values_of(spline.at(kKeys[k].time_s)),
                   to = values_of(spline.at(kKeys[k + 1].time_s));
        EXPECT_LE(std::abs(to[3] - from[3]), 180) << "the azimuth";
        for (int i = 0; i <= 100; ++i) {
            const double share = i / 100.0;
            const auto now =
                values_of(spline.at(kKeys[k].time_s + share * (kKeys[k + 1].time_s - kKeys[k].time_s)));
            for (std::size_t v = 0; v < now.size(); ++v) {
                EXPECT_GE(now[v], std::min(from[v], to[v]) - 1e-9) << "value " << v << ", key " << k;
                EXPECT_LE(now[v], std::max(from[v], to[v]) + 1e-9) << "value " << v << ", key " << k;
            }
        }
    }
}

TEST(CameraSpline, has_no_jump_in_its_speed_and_is_at_rest_at_both_ends) {
    const CameraSpline spline(kKeys);
    constexpr double kStep = 1e-5;
    const auto speed_at = [&](double time) {
        auto from = values_of(spline.at(time)), to = values_of(spline.at(time + kStep));
        for (std::size_t v = 0; v < to.size(); ++v) to[v] = (to[v] - from[v]) / kStep;
        return to;
    };
    for (const CameraKey& each : kKeys) {
        const auto before = speed_at(each.time_s - kStep), after = speed_at(each.time_s);
        const bool is_end = &each == &kKeys.front() || &each == &kKeys.back();
        for (std::size_t v = 0; v < before.size(); ++v) {
            EXPECT_NEAR(before[v], after[v], 0.05) << "value " << v << " at " << each.time_s;
            if (is_end) {
                EXPECT_NEAR(after[v], 0, 0.05) << "value " << v << " at " << each.time_s;
            }
        }
    }
    EXPECT_GT(speed_at(5)[0], 1) << "it does not stop at a key on its way";
}

TEST(FilmCamera, moves_along_a_path_but_stays_above_the_ground) {
    Overrides overrides;
    overrides.squares = 40;
    const Scene scene = load_scene("winter-avalanche", overrides).value();
    const auto session = Session::begin(scene.scenario, {}, std::nullopt).value();
    const sim::View world = session.view();
    const render::Surroundings none;
    const render::Camera high = render::overview(world);
    render::Camera below = high;
    below.target.z -= 1e4;
    const std::vector<CameraKey> path{{1, high}, {3, below}};
    FilmCamera film(FilmView::kPath, {}, world, none, path, 1);
    EXPECT_NEAR(glm::distance(render::eye(film.camera()), render::eye(high)), 0, 1e-6);
    const CameraRoom room(world, none);
    double last = film.camera().target.z;
    for (const double time : {1.5, 2.0, 2.5, 3.0, 9.0}) {
        film.move(world, none, 16. / 9, {.elapsed_s = 0.5, .world_s = time});
        EXPECT_GE(room.height_above_ground(film.camera()), 0.999 * room.cell()) << time;
        EXPECT_LE(film.camera().target.z, last + 1e-6);
        last = film.camera().target.z;
    }
    EXPECT_NEAR(room.height_above_ground(film.camera()), room.cell(), 1e-6);
}

TEST(PathMaker, keeps_keys_by_time_and_replaces_one_of_the_same_time) {
    PathMaker maker;
    EXPECT_TRUE(maker.add(3, kKeys[0].camera));
    maker.play();
    EXPECT_FALSE(maker.plays()) << "one key is no path";
    EXPECT_TRUE(maker.add(1, kKeys[1].camera));
    EXPECT_TRUE(maker.add(2.00049, kKeys[2].camera));
    ASSERT_EQ(maker.keys().size(), 3u);
    EXPECT_EQ(maker.keys()[1].time_s, 2) << "to a thousandth";
    EXPECT_TRUE(maker.add(2.04, kKeys[3].camera));
    ASSERT_EQ(maker.keys().size(), 3u);
    EXPECT_EQ(maker.keys()[1].camera.target, kKeys[3].camera.target);
    EXPECT_EQ(maker.keys()[1].camera.azimuth_deg, -60);
    maker.play();
    EXPECT_TRUE(maker.plays());
    maker.remove(7);
    maker.remove(0);
    EXPECT_TRUE(maker.plays());
    maker.remove(0);
    EXPECT_FALSE(maker.plays());
    EXPECT_EQ(maker.spline().ends_s(), 3);
    for (int i = 0; i < 200; ++i) maker.add(i, kKeys[0].camera);
    EXPECT_EQ(maker.keys().size(), kMostCameraKeys);
    EXPECT_TRUE(maker.add(5, kKeys[1].camera)) << "one that there is can change";
    EXPECT_FALSE(maker.add(-1, kKeys[1].camera));
    EXPECT_FALSE(maker.add(1e6, kKeys[1].camera));
}

class CameraPathFile : public testing::Test {
  protected:
    Outcome<std::vector<CameraKey>> load(const std::string& text) const {
        write_bytes(file(), text);
        return load_camera_path(file());
    }
    fs::path file() const { return folder_.path() / "a.toml"; }
    support::TemporaryFolder folder_;
};

TEST_F(CameraPathFile, has_the_keys_that_were_written) {
    std::vector<CameraKey> keys = kKeys;
    keys[1].camera.target.x = 1.0 / 3;
    const auto loaded = load(camera_path_text(keys));
    ASSERT_TRUE(loaded) << loaded.error().sentence;
    EXPECT_EQ(*loaded, keys);
}

TEST_F(CameraPathFile, is_refused_with_its_line_and_what_is_wrong) {
    const std::string row = "[[camera_path]]\ntime = {}\ntarget = [0, 0, 0]\n";
    const std::string one = fmt::format(fmt::runtime(row), 1), two = fmt::format(fmt::runtime(row), 2);
    ASSERT_TRUE(load(one + two));
    std::string many;
    for (std::size_t i = 0; i <= kMostCameraKeys; ++i) many += fmt::format(fmt::runtime(row), i);
    struct Case {
        std::string text;
        const char *place, *fact;
    };
    for (const Case& each : {Case{"", ": ", "no rows"},
                             {one, ":1: ", "1 rows"},
                             {many, ":1: ", "65 rows"},
                             {two + one, ":5: ", "not later"},
                             {one + one, ":5: ", "not later"},
                             {one + two + "roll = 3\n", ":7: ", "not a known key"},
                             {one + two + "elevation = 90\n", ":7: ", "elevation"},
                             {one + two + "distance = 0\n", ":7: ", "distance"},
                             {one + "[[camera_path]]\ntime = 2\n", ":4: ", "target"},
                             {one + "[[camera_path]]\ntarget = [0, 0, 0]\n", ":4: ", "time"},
                             {one + "[[camera_path]]\ntime = 2\ntarget = [0, 0, 1e300]\n", ":6: ", "target"},
                             {one + "[[camera_path]]\ntime = -1\ntarget = [0, 0, 0]\n", ":5: ", "time"},
                             {"camera_path = 3\n", ":1: ", "list of tables"},
                             {one + two + "[camera]\ntarget = [0, 0, 0]\n", ":7: ", "not a known key"},
                             {"[[camera_path]\n", ":1: ", ""}}) {
        const auto loaded = load(each.text);
        ASSERT_FALSE(loaded) << each.text;
        EXPECT_EQ(loaded.error().status, Failure::kUnusable);
        const std::string& sentence = loaded.error().sentence;
        EXPECT_EQ(sentence.rfind(file().string() + each.place, 0), 0u) << sentence;
        EXPECT_NE(sentence.find(each.fact), std::string::npos) << sentence;
        EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    }
    EXPECT_EQ(load_camera_path(folder_.path() / "none.toml").error().status, Failure::kUnusable);
}

// Of a scene it travels in its recording, and a world that is saved later has other times.
TEST_F(CameraPathFile, is_part_of_a_scene_and_of_its_recording) {
    const std::string scene = read_bytes(support::source_dir() / "assets/scenes/landslide.toml");
    write_bytes(file(), scene + "\n" + camera_path_text(kKeys));
    Overrides overrides;
    overrides.squares = 16;
    const auto loaded = load_scene(file().string(), overrides);
    ASSERT_TRUE(loaded) << loaded.error().sentence;
    EXPECT_EQ(loaded->scenario.camera_path, kKeys);
    const fs::path recording = folder_.path() / "a.couloir";
    write_bytes(recording, recording_of(loaded->scenario));
    const auto read = read_recording(recording);
    ASSERT_TRUE(read) << read.error().sentence;
    EXPECT_EQ(read->header.scenario.camera_path, kKeys);
    const auto session = Session::begin(loaded->scenario, {}, std::nullopt).value();
    EXPECT_TRUE(scenario_of_now(loaded->scenario, session.state()).value().camera_path.empty());
}

}  // namespace
}  // namespace game::test
