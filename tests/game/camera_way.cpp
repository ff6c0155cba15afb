#include "game/controls/camera_control.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tests/game/camera_hands.h"
#include "tests/support/allocations.h"

namespace game::test {
namespace {

using Drag = CameraWish::Drag;

// The same hands for a second, told in frames of different lengths; where the shown camera is at every 30th.
std::vector<render::Camera> second_of(int frames_per_second, CameraMode mode) {
    Hands hands(valley(), over({300, 250}, 1040, 350, 35, 500));
    if (mode == CameraMode::kFly) hands.control.fly(true);
    const int part = frames_per_second / 30;
    const glm::dvec3 pivot = hands.ground({0.1, -0.2}).value();
    std::vector<render::Camera> seen;
    for (int i = 0; i < frames_per_second; ++i) {
        const double t = static_cast<double>(i) / frames_per_second, dt = 1.0 / frames_per_second;
        CameraWish wish;
        wish.pivot = pivot;
        if (i == 5 * part) wish.zoom_steps = 2;
        if (i >= 10 * part && i < 20 * part) {
            wish.drag = i < 15 * part ? Drag::kTurn : Drag::kPan;
            wish.from = {0.1 + t, -0.2 + t / 2};
            wish.to = {0.1 + t + dt, -0.2 + (t + dt) / 2};
        }
        if (i >= 20 * part && i < 25 * part) wish.walk = {0.5, 1, 0.2};
        hands.frame(wish, dt);
        if ((i + 1) % part == 0) seen.push_back(hands.camera());
    }
    return seen;
}

TEST(CameraControl, takes_the_same_path_at_any_frame_rate) {
    for (const CameraMode mode : {CameraMode::kOrbit, CameraMode::kFly}) {
        const auto slow = second_of(30, mode);
        EXPECT_GT(glm::distance(render::eye(slow.front()), render::eye(slow.back())), 50);
        for (const int rate : {60, 240}) {
            const auto quick = second_of(rate, mode);
            for (std::size_t i = 0; i < slow.size(); ++i) {
                EXPECT_LT(glm::distance(render::eye(slow[i]), render::eye(quick[i])), 1e-6)
                    << rate << ", " << i;
                EXPECT_NEAR(slow[i].azimuth_deg, quick[i].azimuth_deg, 1e-6);
                EXPECT_NEAR(slow[i].elevation_deg, quick[i].elevation_deg, 1e-6);
            }
        }
    }
}

TEST(CameraControl, has_done_most_of_the_way_in_a_quarter_of_a_second) {
    Hands hands(level(), over({300, 300}, 0, 100, 35, 500));
    CameraWish wish;
    wish.drag = Drag::kTurn;
    wish.to = {0.5, 0};
    hands.frame(wish, 0);
    EXPECT_EQ(hands.camera().azimuth_deg, 100);
    hands.frame({}, 0.08);
    EXPECT_NEAR(hands.camera().azimuth_deg, 145 - 45 * std::exp(-1.0), 1e-6);
    hands.frame({}, 0.17);
    EXPECT_GT(hands.camera().azimuth_deg, 142);
    hands.frame({}, 10);
    EXPECT_TRUE(hands.control.still());
}

TEST(CameraControl, rests_to_the_bit_once_it_has_arrived) {
    Hands hands(valley(), over({300, 300}, 1040, 350, 30, 700));
    EXPECT_TRUE(hands.control.still());
    hands.drag(Drag::kTurn, {0, 0}, {-0.5, 0.1}, 10);
    EXPECT_FALSE(hands.control.still());
    hands.settle();
    const render::Camera arrived = hands.camera();
    for (int i = 0; i < 100; ++i) hands.frame();
    EXPECT_TRUE(hands.control.still());
    EXPECT_EQ(hands.camera().target, arrived.target);
    EXPECT_EQ(hands.camera().azimuth_deg, arrived.azimuth_deg);
    EXPECT_EQ(hands.camera().elevation_deg, arrived.elevation_deg);
    EXPECT_EQ(hands.camera().distance_m, arrived.distance_m);
}

TEST(CameraControl, keeps_its_eye_above_the_ground_whatever_hands_do) {
    std::mt19937 random(3);
    const auto between = [&](double a, double b) {
        return a + (b - a) * static_cast<double>(random()) / 4294967296.0;
    };
    for (int run = 0; run < 20; ++run) {
        Hands hands(valley(), over({300, 300}, 1040, between(0, 360), 30, 400));
        CameraWish wish;
        for (int i = 0; i < 600; ++i) {
            if (i % 20 == 0) {
                wish = {};
                wish.drag = static_cast<Drag>(random() % 3);
                wish.from = {between(-1, 1), between(-1, 1)};
                wish.pivot = hands.ground(wish.from);
                wish.walk = glm::round(glm::dvec3(between(-1, 1), between(-1, 1), between(-1.4, 0.6)));
                wish.fast = random() % 2 == 0;
                if (random() % 10 == 0) hands.control.fly(random() % 2 == 0);
                if (random() % 10 == 0) hands.control.top_down(random() % 2 == 0);
                if (random() % 20 == 0) hands.control.overview();
            }
            wish.zoom_steps = random() % 5 == 0 ? std::round(between(-1, 3)) : 0;
            wish.to = wish.from + glm::dvec2(between(-0.1, 0.1), between(-0.05, 0.1));
            hands.frame(wish);
            wish.from = wish.to;
            ASSERT_TRUE(finite(hands.camera()));
            ASSERT_GT(clearance(hands.camera(), sim::view(hands.state)), 0.99 * kCell);
        }
        hands.settle();
    }
}

TEST(CameraControl, keeps_its_eye_above_the_mountains_around) {
    Hands hands(valley(), over({300, 300}, 1040, 0, 30, 400));
    std::vector<float> bedrock, depth(hands.state.grid.size());
    const std::vector<std::uint8_t> has_data(hands.state.grid.size(), 1);
    for (int y = 0; y < hands.state.grid.ny; ++y)
        for (int x = 0; x < hands.state.grid.nx; ++x) bedrock.push_back(hands.state.bedrock(x, y));
    hands.around = {hands.state.grid, bedrock, depth, has_data};
    int outside = 0;
    for (int i = 0; i < 24; ++i) {
        CameraWish wish;
        wish.walk = {std::round(std::sin(i)), 1, -1};  // down and away
        wish.fast = true;
        if (i % 6 == 0) hands.control.overview();
        hands.control.fly(true);
        wish.drag = Drag::kTurn;
        wish.to = {0.3, 0};
        hands.frame(wish);
        wish.drag = Drag::kNone;
        for (int k = 0; k < 60; ++k) {
            hands.frame(wish);
            const glm::dvec3 eye = render::eye(hands.camera());
            if (hands.around.away(eye) == 0) continue;
            ++outside;
            ASSERT_GT(eye.z - hands.state.datum - hands.around.height(eye), 0.99 * kCell);
        }
    }
    EXPECT_GT(outside, 200);
}

TEST(CameraControl, is_lifted_by_ground_that_rises) {
    Hands hands(level(), over({300, 300}, 0, 180, 89, 2.5 * kCell));
    for (int i = 0; i < 120; ++i) {
        hands.state.depth.fill(static_cast<float>(i));
        hands.frame();
        EXPECT_GT(clearance(hands.camera(), sim::view(hands.state)), 0.99 * kCell);
    }
    hands.settle();
}

TEST(CameraControl, bears_frames_of_no_time_and_of_ten_seconds_and_wild_hands) {
    for (const double seconds : {0.0, -1.0, 1e-9, 1.0, 10.0, 1e9})
        for (const Drag kind : {Drag::kNone, Drag::kTurn, Drag::kPan})
            for (const double much : {-1e12, -40.0, 40.0, 1e12}) {
                SCOPED_TRACE(testing::Message()
                             << seconds << " s, drag " << static_cast<int>(kind) << ", " << much);
                Hands hands(valley(), over({300, 300}, 1040, 250, 40, 600));
                CameraWish wish;
                wish.drag = kind;
                wish.to = {much, -much};
                wish.zoom_steps = much;
                wish.walk = glm::dvec3(much);
                wish.pivot = much > 1e9 ? glm::dvec3(much) : hands.ground({0, 0}).value();
                for (int i = 0; i < 5; ++i) {
                    hands.control.move(wish, sim::view(hands.state), hands.around, i % 2 == 0 ? kAspect : 0,
                                       seconds);
                    ASSERT_TRUE(finite(hands.camera()));
                    ASSERT_GT(clearance(hands.camera(), sim::view(hands.state)), 0.99 * kCell);
                }
                hands.settle();
            }
}

TEST(CameraControl, allocates_nothing) {
    Hands hands(valley(), over({300, 300}, 1040, 250, 40, 600));
    const std::int64_t before = support::allocations();
    for (int i = 0; i < 60; ++i) {
        CameraWish wish;
        wish.drag = static_cast<Drag>(i % 3);
        wish.to = {0.1, 0.1};
        wish.zoom_steps = i % 2;
        wish.walk = {1, 1, 0};
        hands.control.top_down(i % 20 == 0);
        hands.frame(wish);
    }
    EXPECT_EQ(support::allocations() - before, 0);
}

}  // namespace
}  // namespace game::test
