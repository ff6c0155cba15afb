#include "game/controls/shots.h"

#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include <glm/trigonometric.hpp>

#include "game/controls/camera_path.h"
#include "game/scene/scene.h"
#include "game/scene/surface.h"
#include "game/session/session.h"
#include "tests/game/camera_hands.h"

namespace game::test {
namespace {

struct Cut {
    double at_s = 0;
    render::Camera camera;
    std::optional<SlideFront::Front> front;
    double above_ground = 0;  // m, of the eye
};

// Of a film of the slide, at the speed at which it runs.
std::vector<Cut> cuts_of(const char* scene_name, const render::Camera& whole, double seconds) {
    Overrides overrides;
    overrides.squares = 80;
    const Scene scene = load_scene(scene_name, overrides).value();
    auto session = Session::begin(scene.scenario, sim::StepOptions{}, std::nullopt).value();
    const render::Surroundings around;
    SlideFront front;
    Shots shots(whole);
    render::Camera now = whole;
    std::vector<Cut> cuts;
    std::size_t next = 0;
    while (session.seconds() < seconds) {
        const sim::View world = session.view();
        front.see(world);
        if (const auto pose = shots.next({now, front.front(), world, around, 16.0 / 9, session.seconds()})) {
            now = *pose;
            const glm::dvec3 eye = render::eye(now);
            cuts.push_back(
                {session.seconds(), now, front.front(), eye.z - surface_height(world, glm::dvec2(eye))});
        }
        std::vector<sim::Command> due;
        for (; next < scene.commands.size() && scene.commands[next].tick == session.state().tick; ++next)
            due.push_back(scene.commands[next].command);
        if (!session.advance(due)) break;
    }
    return cuts;
}

TEST(Shots, go_down_the_path_of_a_slide_and_return_to_the_whole) {
    const render::Camera whole{.target = {1000, 1000, 1500}, .distance_m = 2500};
    const std::vector<Cut> cuts = cuts_of("winter-avalanche", whole, 40);
    ASSERT_EQ(cuts.size(), 5u);
    EXPECT_EQ(cuts.front().camera, whole);
    EXPECT_EQ(cuts.back().camera, whole);
    double side = 0;
    for (std::size_t i = 1; i + 1 < cuts.size(); ++i) {
        const Cut& cut = cuts[i];
        ASSERT_TRUE(cut.front) << i;
        const Sight sight = sight_of(cut.front->at, cut.camera);
        const double up = std::tan(glm::radians(cut.camera.field_of_view_deg / 2));
        EXPECT_GT(sight.depth, 0) << i;
        EXPECT_LT(std::abs(sight.at.x), up * 16 / 9) << i;
        EXPECT_LT(std::abs(sight.at.y), up) << i;
        EXPECT_GT(cut.above_ground, 20) << i;
        // From ahead, and from the other side than before.
        const double heading = glm::degrees(std::atan2(cut.front->heading.x, cut.front->heading.y)),
                     aside = std::remainder(cut.camera.azimuth_deg - heading, 360.0);
        EXPECT_LT(std::abs(aside), 91) << i;
        EXPECT_LT(aside * side, 1e-9) << i;
        side = aside;
        const double lasts = cuts[i + 1].at_s - cut.at_s;
        EXPECT_GE(lasts, 1.5 - 1e-6) << i;
        EXPECT_LE(lasts, 6.1) << i;
    }
}

TEST(Shots, stay_with_the_whole_while_nothing_moves) {
    sim::State state = level();
    const render::Camera whole{.distance_m = 700};
    const render::Surroundings around;
    Shots shots(whole);
    const std::optional<SlideFront::Front> none;
    EXPECT_EQ(shots.next({whole, none, sim::view(state), around, 1.5, 3}), whole);
    for (double now_s = 3; now_s < 60; now_s += 0.1)
        EXPECT_FALSE(shots.next({whole, none, sim::view(state), around, 1.5, now_s}));
}

}  // namespace
}  // namespace game::test
