#include "game/controls/camera_control.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tests/game/camera_hands.h"

namespace game::test {
namespace {

using Drag = CameraWish::Drag;

TEST(CameraControl, turns_about_the_ground_under_the_cursor_all_the_way) {
    for (const CameraCase& c : cases()) {
        Hands hands(valley(), c.camera);
        const glm::dvec3 pivot = hands.ground(c.place).value();
        double astray = 0;
        const auto see = [&] {
            astray = std::max(astray, glm::distance(in_picture(hands.camera(), pivot), c.place));
        };
        hands.drag(Drag::kTurn, c.place, c.place + glm::dvec2(0.9, -0.1), 12, see);
        hands.settle(see);
        EXPECT_NEAR(std::remainder(hands.camera().azimuth_deg - c.camera.azimuth_deg, 360), 81, 1e-6);
        EXPECT_LT(astray, 1e-6);
    }
}

TEST(CameraControl, turns_half_round_over_a_picture_width_and_keeps_above_3_and_below_89_degrees) {
    Hands hands(level(), over({300, 300}, 0, 200, 35, 500));
    hands.drag(Drag::kTurn, {-1, 0}, {1, 0}, 30);
    hands.settle();
    EXPECT_NEAR(hands.camera().azimuth_deg, 20, 1e-6);
    EXPECT_NEAR(hands.camera().elevation_deg, 35, 1e-6);
    hands.drag(Drag::kTurn, {0, 0}, {0, -8}, 30);
    hands.settle();
    EXPECT_NEAR(hands.camera().elevation_deg, 89, 1e-6);
    hands.drag(Drag::kTurn, {0, 0}, {0, 8}, 30);
    hands.settle();
    EXPECT_NEAR(hands.camera().elevation_deg, 3, 1e-6);
}

TEST(CameraControl, pans_so_that_the_ground_stays_under_the_cursor) {
    for (const CameraCase& c : cases()) {
        Hands hands(valley(), c.camera);
        const glm::dvec3 pivot = hands.ground(c.place).value();
        const glm::dvec2 to = c.place + glm::dvec2(c.place.x > 0 ? -0.5 : 0.5, c.place.y > 0 ? -0.4 : 0.4);
        const glm::dvec2 way = to - c.place;
        double aside = 0;
        hands.drag(Drag::kPan, c.place, to, 10, [&] {
            const glm::dvec2 gone = in_picture(hands.camera(), pivot) - c.place;
            aside = std::max(aside, std::abs(gone.x * way.y - gone.y * way.x) / glm::length(way));
        });
        hands.settle();
        const glm::dvec2 arrived = in_picture(hands.camera(), pivot);
        EXPECT_LT(glm::distance(arrived, to), 1e-5);
        EXPECT_LT(aside, 1e-6);  // straight across the picture
        EXPECT_EQ(hands.camera().elevation_deg, c.camera.elevation_deg);
        EXPECT_NEAR(hands.camera().azimuth_deg, c.camera.azimuth_deg, 1e-9);
    }
}

TEST(CameraControl, pans_at_the_height_of_the_eye_and_along_the_picture_where_the_ray_is_flat) {
    Hands high(level(), over({300, 300}, 0, 180, 40, 500));
    const double height = render::eye(high.camera()).z;
    high.drag(Drag::kPan, {0, 0}, {0.5, 0.5}, 10);
    high.settle();
    EXPECT_NEAR(render::eye(high.camera()).z, height, 1e-6);

    Hands low(level(), over({300, 300}, 0, 180, 4, 500));
    const glm::dvec3 before = render::eye(low.camera());
    const glm::dvec3 pivot = low.ground({0, 0}).value();
    low.drag(Drag::kPan, {0, 0}, {0.5, 0.1}, 10);
    low.settle();
    EXPECT_LT(glm::distance(in_picture(low.camera(), pivot), {0.5, 0.1}), 1e-5);
    EXPECT_LT(glm::distance(render::eye(low.camera()), before),
              200);  // over the ground it would be kilometres
}

TEST(CameraControl, zooms_to_the_ground_under_the_cursor_all_the_way) {
    for (const CameraCase& c : cases())
        for (const double steps : {3.0, -3.0}) {
            Hands hands(valley(), c.camera);
            const glm::dvec3 pivot = hands.ground(c.place).value();
            const double before = glm::distance(render::eye(hands.camera()), pivot);
            hands.wheel(c.place, steps);
            double astray = 0;
            hands.settle([&] {
                astray = std::max(astray, glm::distance(in_picture(hands.camera(), pivot), c.place));
            });
            EXPECT_LT(astray, 1e-6);
            EXPECT_NEAR(glm::distance(render::eye(hands.camera()), pivot), before * std::pow(0.85, steps),
                        before * 1e-4);
        }
}

// Picture coordinates span 2, so 2 % of the picture are 0.04.
TEST(CameraControl, holds_what_is_grabbed_while_the_camera_is_still_on_its_way) {
    for (const CameraCase& c : cases()) {
        Hands hands(valley(), c.camera);
        hands.wheel(-c.place, 2);
        hands.drag(Drag::kTurn, c.place, c.place + glm::dvec2(0.2, 0), 2);
        const auto pivot = hands.ground(c.place / 2.0);
        if (!pivot) continue;
        double astray = 0;
        const auto see = [&] {
            astray = std::max(astray, glm::distance(in_picture(hands.camera(), *pivot), c.place / 2.0));
        };
        for (int i = 0; i < 4; ++i) {
            hands.wheel(c.place / 2.0, 1);
            see();
        }
        hands.drag(Drag::kTurn, c.place / 2.0, c.place / 2.0 + glm::dvec2(-0.3, -0.1), 10, see);
        hands.settle(see);
        EXPECT_LT(astray, 0.04);
    }
}

TEST(CameraControl, zooms_no_nearer_than_two_cells_and_no_farther_than_six_diagonals) {
    Hands hands(level(), over({300, 300}, 0, 200, 50, 500));
    const double diagonal = kSide * std::sqrt(2.0);
    for (int i = 0; i < 60; ++i) hands.wheel({0, 0}, 1);
    hands.settle();
    EXPECT_NEAR(hands.camera().distance_m, 2 * kCell, 0.01);
    for (int i = 0; i < 60; ++i) hands.wheel({0, 0}, -3);
    hands.settle();
    EXPECT_NEAR(hands.camera().distance_m, 6 * diagonal, 0.01 * diagonal);
}

TEST(CameraControl, stops_a_zoom_a_cell_above_the_ground_and_still_holds_it) {
    Hands hands(level(), over({300, 300}, 0, 200, 20, 500));
    const glm::dvec3 pivot = hands.ground({0.3, -0.2}).value();
    for (int i = 0; i < 30; ++i) hands.wheel({0.3, -0.2}, 1);
    hands.settle();
    EXPECT_NEAR(clearance(hands.camera(), sim::view(hands.state)), kCell, 0.01);
    EXPECT_LT(glm::distance(in_picture(hands.camera(), pivot), {0.3, -0.2}), 0.02);
}

TEST(CameraControl, does_without_ground_under_the_cursor) {
    Hands hands(level(), over({300, 300}, 0, 180, 10, 400));
    ASSERT_FALSE(hands.ground({0.2, 0.95}));
    hands.drag(Drag::kTurn, {0.2, 0.95}, {0.4, 0.95}, 5);
    hands.settle();
    EXPECT_NEAR(hands.camera().azimuth_deg, 198, 1e-6);
    EXPECT_LT(glm::distance(in_picture(hands.camera(), {300, 300, 0}), {0, 0}), 1e-6);
    hands.drag(Drag::kPan, {0.2, 0.95}, {0, 0.95}, 5);
    hands.settle();
    EXPECT_LT(glm::distance(in_picture(hands.camera(), {300, 300, 0}), {-0.2, 0}), 1e-6);
    hands.wheel({0.2, 0.95}, 1);
    hands.settle();
    EXPECT_NEAR(hands.camera().distance_m, 400 * 0.85, 1e-3);
}

// A wall 150 m high stands where the eye would go; a pan runs into it too.
TEST(CameraControl, rises_over_the_mountain_in_its_way_and_still_holds_the_ground) {
    const auto walled = [] {
        sim::State world = level();
        for (int y = 0; y <= 15; ++y)
            for (int x = 0; x <= 60; ++x) world.depth(x, y) = 150;
        return world;
    };
    Hands turning(walled(), over({300, 250}, 0, 0, 10, 200));
    turning.drag(Drag::kTurn, {0, 0}, {2, 0}, 60);
    turning.settle();
    EXPECT_NEAR(turning.camera().azimuth_deg, 180, 1e-6);
    EXPECT_NEAR(clearance(turning.camera(), sim::view(turning.state)), kCell, 0.01);
    EXPECT_LT(glm::length(in_picture(turning.camera(), {300, 250, 0})), 1e-6);
    EXPECT_NEAR(turning.camera().distance_m, 200, 1e-6);

    Hands panning(walled(), over({300, 400}, 0, 180, 20, 200));
    const glm::dvec3 pivot = panning.ground({0, 0.5}).value();
    panning.drag(Drag::kPan, {0, 0.5}, {0, 0.9}, 60);
    panning.settle();
    EXPECT_NEAR(clearance(panning.camera(), sim::view(panning.state)), kCell, 0.1);
    EXPECT_LT(glm::distance(in_picture(panning.camera(), pivot), {0, 0.9}), 1e-5);
}

}  // namespace
}  // namespace game::test
