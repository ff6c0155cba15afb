#include "game/controls/camera_control.h"

#include <cmath>

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tests/game/camera_hands.h"

namespace game::test {
namespace {

using Drag = CameraWish::Drag;

TEST(CameraControl, walks_half_of_its_distance_in_a_second_and_four_times_as_far_in_haste) {
    for (const double distance : {100.0, 400.0})
        for (const bool fast : {false, true}) {
            Hands hands(level(), over({300, 100}, 0, 180, 35, distance));
            CameraWish wish;
            wish.walk = {0, 1, 0};
            wish.fast = fast;
            for (int i = 0; i < 60; ++i) hands.frame(wish);
            hands.settle();
            EXPECT_NEAR(hands.camera().target.x, 300, 1e-3);
            EXPECT_NEAR(hands.camera().target.y, 100 + distance * (fast ? 2 : 0.5), 1e-3);
            EXPECT_NEAR(hands.camera().target.z, 0, 1e-3);
            EXPECT_NEAR(hands.camera().distance_m, distance, 1e-3);
        }
}

TEST(CameraControl, flies_where_it_looks_and_looks_around_from_where_it_is) {
    Hands hands(level(), over({300, 300}, 0, 180, 30, 400));
    hands.control.fly(true);
    EXPECT_EQ(hands.control.mode(), CameraMode::kFly);
    const glm::dvec3 eye = render::eye(hands.camera());
    hands.drag(Drag::kTurn, {0, 0}, {0.5, 0.2}, 10,
               [&] { EXPECT_LT(glm::distance(render::eye(hands.camera()), eye), 1e-6); });
    hands.settle();
    EXPECT_NEAR(hands.camera().azimuth_deg, 225, 1e-6);
    EXPECT_LT(hands.camera().elevation_deg, 30);
    const glm::dvec3 forward = glm::normalize(hands.camera().target - eye);
    CameraWish wish;
    wish.walk = {0, 1, 0};
    for (int i = 0; i < 30; ++i) hands.frame(wish);
    hands.settle();
    const glm::dvec3 way = render::eye(hands.camera()) - eye;
    EXPECT_GT(glm::length(way), 50);
    EXPECT_GT(glm::dot(glm::normalize(way), forward), 1 - 1e-9);
}

TEST(CameraControl, comes_back_from_flying_to_an_elevation_for_orbit) {
    Hands hands(level(), over({300, 300}, 0, 180, 30, 400));
    hands.control.fly(true);
    hands.drag(Drag::kTurn, {0, 0}, {0, 2}, 10);
    hands.settle();
    EXPECT_LT(hands.camera().elevation_deg, -20);
    hands.control.fly(false);
    hands.settle();
    EXPECT_EQ(hands.camera().elevation_deg, 3);
}

TEST(CameraControl, looks_straight_down_on_the_middle_as_on_a_map_and_back) {
    for (const CameraCase& c : cases()) {
        if (!ground_at(c.camera, sim::view(valley()), {0, 0})) continue;
        Hands hands(valley(), c.camera);
        const glm::dvec3 middle = hands.ground({0, 0}).value();
        const double away = glm::distance(render::eye(hands.camera()), middle);
        hands.control.top_down(true);
        EXPECT_FALSE(hands.control.still());
        hands.settle();
        EXPECT_EQ(hands.control.mode(), CameraMode::kTopDown);
        EXPECT_NEAR(hands.camera().elevation_deg, 89.9, 1e-9);
        EXPECT_NEAR(hands.camera().azimuth_deg, 180, 1e-9);
        EXPECT_LT(glm::distance(in_picture(hands.camera(), middle), {0, 0}), 0.01);
        EXPECT_NEAR(glm::distance(render::eye(hands.camera()), middle), away, 1);
        hands.drag(Drag::kPan, {0, 0}, {0.3, 0.4}, 5);
        hands.wheel({0.1, 0.1}, 1);
        hands.control.top_down(false);
        hands.settle();
        EXPECT_EQ(hands.control.mode(), CameraMode::kOrbit);
        EXPECT_LT(glm::distance(hands.camera().target, c.camera.target), 1e-9);
        EXPECT_NEAR(hands.camera().azimuth_deg, c.camera.azimuth_deg, 1e-9);
        EXPECT_EQ(hands.camera().elevation_deg, c.camera.elevation_deg);
        EXPECT_EQ(hands.camera().distance_m, c.camera.distance_m);
    }
}

TEST(CameraControl, pans_zooms_and_does_not_turn_from_the_top) {
    Hands hands(valley(), over({300, 300}, 1040, 250, 40, 600));
    hands.control.top_down(true);
    hands.settle();
    const render::Camera before = hands.camera();
    hands.drag(Drag::kTurn, {0, 0}, {0.5, 0.5}, 5);
    hands.settle();
    EXPECT_EQ(glm::distance(render::eye(hands.camera()), render::eye(before)), 0);
    EXPECT_EQ(hands.camera().azimuth_deg, before.azimuth_deg);

    const glm::dvec3 pivot = hands.ground({0.2, 0.1}).value();
    hands.drag(Drag::kPan, {0.2, 0.1}, {-0.3, 0.4}, 5);
    hands.settle();
    EXPECT_LT(glm::distance(in_picture(hands.camera(), pivot), {-0.3, 0.4}), 1e-5);
    hands.wheel({-0.3, 0.4}, 3);
    hands.settle();
    EXPECT_LT(glm::distance(in_picture(hands.camera(), pivot), {-0.3, 0.4}), 1e-3);
    EXPECT_NEAR(hands.camera().elevation_deg, 89.9, 1e-9);
    hands.control.fly(true);
    EXPECT_EQ(hands.control.mode(), CameraMode::kFly);
    hands.settle();
    EXPECT_NEAR(hands.camera().elevation_deg, 40, 1e-9);
}

TEST(CameraControl, follows_what_moves_from_ahead_of_it_until_it_is_panned) {
    for (const double azimuth : {100.0, 260.0}) {
        Hands hands(level(), over({300, 300}, 0, azimuth, 50, 900));
        hands.control.chase(true);
        hands.frame();
        EXPECT_EQ(hands.control.mode(), CameraMode::kChase);
        EXPECT_EQ(hands.camera().distance_m, 900) << "nothing to follow yet";
        CameraWish wish;
        wish.followed = CameraWish::Followed{{300, 500, 0}, {0, -1}};
        for (int i = 0; i < 300; ++i) {
            wish.followed->at.y -= 0.5;  // 30 m/s
            hands.frame(wish);
        }
        // Behind it by what it runs in half a second, the delays of the camera being short.
        EXPECT_LT(glm::distance(hands.camera().target, wish.followed->at), 25);
        EXPECT_NEAR(hands.camera().distance_m, 400, 1e-6);
        EXPECT_NEAR(std::remainder(hands.camera().azimuth_deg - 180, 360), azimuth < 180 ? -35 : 35, 1e-6);
        const glm::dvec3 ahead = render::eye(hands.camera()) - wish.followed->at;
        EXPECT_GT(glm::dot(glm::dvec2(ahead), glm::dvec2(0, -1)), 100);

        // One may look at it from elsewhere, and nearer.
        wish.drag = Drag::kTurn, wish.to = {0.2, 0};
        hands.frame(wish);
        wish.drag = Drag::kNone, wish.zoom_steps = 2;
        hands.frame(wish);
        wish.zoom_steps = 0;
        for (int i = 0; i < 200; ++i) hands.frame(wish);
        EXPECT_EQ(hands.control.mode(), CameraMode::kChase);
        EXPECT_LT(hands.camera().distance_m, 300);
        EXPECT_LT(glm::distance(hands.camera().target, wish.followed->at), 1);

        wish.drag = Drag::kPan, wish.from = {0, 0}, wish.to = {0.1, 0};
        hands.frame(wish);
        EXPECT_EQ(hands.control.mode(), CameraMode::kOrbit);
        const glm::dvec3 left = hands.camera().target;
        wish = {};
        wish.followed = CameraWish::Followed{{0, 0, 0}, {0, -1}};
        hands.settle();
        for (int i = 0; i < 60; ++i) hands.frame(wish);
        EXPECT_LT(glm::distance(hands.camera().target, left), 100);
    }
}

TEST(CameraControl, flies_home_on_the_short_way) {
    const render::Camera home = over({300, 300}, 1040, 350, 30, 700);
    Hands hands(valley(), home);
    hands.drag(Drag::kTurn, {0, 0}, {0.5, 0}, 10);  // to 35°, across north
    hands.control.fly(true);
    hands.settle();
    EXPECT_NEAR(hands.camera().azimuth_deg, 35, 1e-6);
    hands.control.overview();
    EXPECT_EQ(hands.control.mode(), CameraMode::kOrbit);
    EXPECT_FALSE(hands.control.still());
    hands.settle([&] { EXPECT_LT(std::abs(std::remainder(hands.camera().azimuth_deg - 12.5, 360)), 22.6); });
    EXPECT_LT(glm::distance(hands.camera().target, home.target), 1e-9);
    EXPECT_NEAR(hands.camera().azimuth_deg, 350, 1e-9);
    EXPECT_EQ(hands.camera().distance_m, home.distance_m);
}

TEST(CameraControl, takes_hold_anew_where_a_drag_goes_on_across_a_change_of_view) {
    Hands hands(level(), over({300, 300}, 0, 180, 30, 400));
    CameraWish wish;
    wish.drag = Drag::kTurn;
    wish.to = {0.1, 0};
    hands.frame(wish);
    hands.control.overview();
    hands.frame(wish);
    hands.settle();
    EXPECT_NEAR(hands.camera().azimuth_deg, 189, 1e-6);
    EXPECT_LT(glm::distance(hands.camera().target, {300, 300, 0}), 1);  // not about the middle of nowhere
}

}  // namespace
}  // namespace game::test
