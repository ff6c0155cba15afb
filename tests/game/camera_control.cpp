#include "game/camera_control.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "game/surface.h"
#include "tests/support/allocations.h"
#include "tests/support/worlds.h"

namespace game::test {
namespace {

using Drag = CameraWish::Drag;

constexpr double kAspect = 16.0 / 9, kCell = 10, kSide = 600;  // m
constexpr double kFrame = 1.0 / 60;                            // s

// A valley of 60 × 60 squares with knolls, 1000 m above the terrain's zero.
sim::State valley() {
    support::Ground ground({61, 61, static_cast<float>(kCell)});
    ground.set(ground.bedrock, [](double x, double y) {
        return 0.3 * std::abs(x - 300) + 0.1 * y + 15 * std::sin(x / 60) * std::cos(y / 45);
    });
    ground.set(ground.depth, [](double, double) { return 2; });
    sim::State state = sim::make_state(ground.world(), {});
    state.datum = 1000;
    return state;
}

sim::State level() {
    return sim::make_state(support::plane(60, static_cast<float>(kCell), 0).world(), {});
}

render::Camera over(glm::dvec2 target, double height, double azimuth, double elevation, double distance) {
    render::Camera camera;
    camera.target = {target, height};
    camera.azimuth_deg = azimuth;
    camera.elevation_deg = elevation;
    camera.distance_m = distance;
    return camera;
}

glm::dvec2 in_picture(const render::Camera& camera, glm::dvec3 point) {
    const glm::dvec4 clip =
        render::projection_matrix(camera, kAspect) * render::view_matrix(camera) * glm::dvec4(point, 1);
    EXPECT_GT(clip.w, 0);
    return glm::dvec2(clip) / clip.w;
}

// Walks along the ray of a picture place until it is under the ground; nothing within 3 km.
std::optional<glm::dvec3> ground_at(const render::Camera& camera, const sim::View& world, glm::dvec2 place) {
    const double focal = std::tan(camera.field_of_view_deg * 3.14159265358979323846 / 360);
    const glm::dmat4 view = render::view_matrix(camera);
    const glm::dvec3 along = glm::normalize(
        glm::dvec3(glm::transpose(view) * glm::dvec4(place.x * focal * kAspect, place.y * focal, -1, 0)));
    for (double way = 0; way < 3000; way += 0.5) {
        const glm::dvec3 p = render::eye(camera) + way * along;
        if (p.x < 0 || p.y < 0 || p.x > kSide || p.y > kSide || p.z > surface_height(world, p)) continue;
        return p;
    }
    return std::nullopt;
}

double clearance(const render::Camera& camera, const sim::View& world) {
    const glm::dvec3 eye = render::eye(camera);
    return eye.z - surface_height(world, eye);
}

bool finite(const render::Camera& c) {
    return std::isfinite(c.target.x + c.target.y + c.target.z + c.azimuth_deg + c.elevation_deg) &&
           std::isfinite(c.distance_m) && c.distance_m > 0;
}

// A control over a world, with the frames that hands need.
struct Hands {
    sim::State state;
    CameraControl control;

    Hands(sim::State world, const render::Camera& home)
        : state(std::move(world)), control(home, sim::view(state)) {}
    const render::Camera& camera() const { return control.camera(); }
    std::optional<glm::dvec3> ground(glm::dvec2 place) const {
        return ground_at(camera(), sim::view(state), place);
    }
    void frame(const CameraWish& wish = {}, double seconds = kFrame) {
        control.move(wish, sim::view(state), kAspect, seconds);
    }
    void settle() {
        for (int i = 0; i < 600 && !control.still(); ++i) frame();
        EXPECT_TRUE(control.still());
    }
    // In equal parts; calls `each` after every frame.
    void drag(Drag kind, glm::dvec2 from, glm::dvec2 to, int frames, const std::function<void()>& each = {}) {
        CameraWish wish;
        wish.drag = kind;
        wish.pivot = ground(from);
        for (int i = 0; i < frames; ++i) {
            wish.from = glm::mix(from, to, static_cast<double>(i) / frames);
            wish.to = glm::mix(from, to, (i + 1.0) / frames);
            frame(wish);
            if (each) each();
        }
    }
    void wheel(glm::dvec2 place, double steps) {
        CameraWish wish;
        wish.zoom_steps = steps;
        wish.pivot = ground(place);
        frame(wish);
    }
};

// Many cameras over the valley, each with a place of the picture that shows ground, well inside it.
struct Case {
    render::Camera camera;
    glm::dvec2 place;
};
std::vector<Case> cases() {
    std::mt19937 random(7);
    const auto between = [&](double a, double b) {
        return a + (b - a) * static_cast<double>(random()) / 4294967296.0;
    };
    const sim::State world = valley();
    std::vector<Case> made;
    while (made.size() < 60) {
        const render::Camera camera = over({between(200, 400), between(200, 400)}, between(1030, 1060),
                                           between(0, 360), between(20, 80), std::exp(between(4.6, 7)));
        const glm::dvec2 place(between(-0.8, 0.8), between(-0.8, 0.8));
        if (clearance(camera, sim::view(world)) > 40 && ground_at(camera, sim::view(world), place))
            made.push_back({camera, place});
    }
    return made;
}

TEST(CameraControl, turns_about_the_ground_under_the_cursor_all_the_way) {
    for (const Case& c : cases()) {
        Hands hands(valley(), c.camera);
        const glm::dvec3 pivot = hands.ground(c.place).value();
        double astray = 0;
        const auto see = [&] {
            astray = std::max(astray, glm::distance(in_picture(hands.camera(), pivot), c.place));
        };
        hands.drag(Drag::kTurn, c.place, c.place + glm::dvec2(0.9, -0.1), 12, see);
        while (!hands.control.still()) hands.frame(), see();
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
    for (const Case& c : cases()) {
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
    for (const Case& c : cases())
        for (const double steps : {3.0, -3.0}) {
            Hands hands(valley(), c.camera);
            const glm::dvec3 pivot = hands.ground(c.place).value();
            const double before = glm::distance(render::eye(hands.camera()), pivot);
            hands.wheel(c.place, steps);
            double astray = 0;
            while (!hands.control.still()) {
                astray = std::max(astray, glm::distance(in_picture(hands.camera(), pivot), c.place));
                hands.frame();
            }
            EXPECT_LT(astray, 1e-6);
            EXPECT_NEAR(glm::distance(render::eye(hands.camera()), pivot), before * std::pow(0.85, steps),
                        before * 1e-4);
        }
}

// Picture coordinates span 2, so 2 % of the picture are 0.04.
TEST(CameraControl, holds_what_is_grabbed_while_the_camera_is_still_on_its_way) {
    for (const Case& c : cases()) {
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
        while (!hands.control.still()) hands.frame(), see();
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
    for (const Case& c : cases()) {
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
    while (!hands.control.still()) {
        hands.frame();
        EXPECT_LT(std::abs(std::remainder(hands.camera().azimuth_deg - 12.5, 360)), 22.6);
    }
    EXPECT_LT(glm::distance(hands.camera().target, home.target), 1e-9);
    EXPECT_NEAR(hands.camera().azimuth_deg, 350, 1e-9);
    EXPECT_EQ(hands.camera().distance_m, home.distance_m);
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
                    hands.control.move(wish, sim::view(hands.state), i % 2 == 0 ? kAspect : 0, seconds);
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
