#include <cmath>
#include <numbers>

#include <glm/vec4.hpp>

#include "tests/render/gl_scene.h"

namespace render::test {
namespace {

constexpr int kSize = 300;  // pixels along an edge

Marks with_ring(glm::dvec2 centre, double radius) {
    Marks marks;
    marks.ring = Ring{centre, radius, {1, 0, 1}};
    return marks;
}

Marks with_contours() {
    Marks marks;
    marks.contours = true;
    return marks;
}

// Position of a point in the image, pixels from the left and the top.
glm::dvec2 seen_at(const Camera& camera, glm::dvec3 at) {
    const glm::dvec4 clip = projection_matrix(camera, 1) * view_matrix(camera) * glm::dvec4(at, 1);
    return glm::dvec2(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w) * static_cast<double>(kSize);
}

Colour pixel(const Picture& picture, glm::dvec2 at) {
    return mean_colour(picture, static_cast<int>(at.x), static_cast<int>(at.y), 0);
}

class MarksOnGround : public Gl {
  protected:
    Picture shot(const World& world, const Camera& camera, const Marks& marks, const Light& light = {}) {
        return draw(world, camera, light, plain_look(), kSize, kSize, marks);
    }
};

// A plane that rises to the north at 40° from a height of 1203.7 m, and a camera that views it obliquely.
struct Slope {
    World world =
        make_world(40, 4, [](double, double y) { return std::tan(40 * std::numbers::pi / 180) * y; });
    Camera camera;

    Slope() {
        world.datum = 1203.7;
        camera.target = at(80, 80);
        camera.azimuth_deg = 215;
        camera.elevation_deg = 20;
        camera.distance_m = 150;
    }
    glm::dvec3 at(double x, double y) const {
        return {x, y, world.datum + std::tan(40 * std::numbers::pi / 180) * y};
    }
};

TEST_F(MarksOnGround, ring_is_drawn_on_its_circle_and_follows_a_slope) {
    const Slope slope;
    const Picture plain = shot(slope.world, slope.camera, {});
    const Picture ringed = shot(slope.world, slope.camera, with_ring({84, 78}, 25));
    for (int i = 0; i < 72; ++i) {
        const double x = std::cos(i * std::numbers::pi / 36), y = std::sin(i * std::numbers::pi / 36);
        const auto change = [&](double radius) {
            const glm::dvec2 at = seen_at(slope.camera, slope.at(84 + radius * x, 78 + radius * y));
            return colour_distance(pixel(plain, at), pixel(ringed, at));
        };
        EXPECT_GT(change(25), 40) << i;  // the line
        EXPECT_LT(change(22), 15) << i;  // the tint
        EXPECT_GT(change(22), 0.5) << i;
        EXPECT_EQ(change(28), 0) << i;
    }
    const glm::dvec2 middle = seen_at(slope.camera, slope.at(84, 78));
    EXPECT_GT(colour_distance(pixel(plain, middle), pixel(ringed, middle)), 40);
}

TEST_F(MarksOnGround, ring_changes_no_pixel_outside_it) {
    const Slope slope;
    const Picture plain = shot(slope.world, slope.camera, {});
    const Picture ringed = shot(slope.world, slope.camera, with_ring({-500, 0}, 25));
    EXPECT_TRUE(alike(plain, ringed, rounding()));
}

TEST_F(MarksOnGround, outline_is_drawn_on_its_rectangle_and_follows_a_slope) {
    const Slope slope;
    Marks outlined;
    outlined.outline = outline_of({84, 78}, 30, 40, 24, {1, 0, 1});
    const Picture plain = shot(slope.world, slope.camera, {});
    const Picture marked = shot(slope.world, slope.camera, outlined);
    const double turn = 30 * std::numbers::pi / 180;
    // `ahead` and `right`: m from the middle.
    const auto change = [&](double ahead, double right) {
        const double x = 84 + ahead * std::sin(turn) + right * std::cos(turn),
                     y = 78 + ahead * std::cos(turn) - right * std::sin(turn);
        const glm::dvec2 at = seen_at(slope.camera, slope.at(x, y));
        return colour_distance(pixel(plain, at), pixel(marked, at));
    };
    for (double part = -0.9; part < 1; part += 0.1)
        for (const double side : {-1.0, 1.0}) {
            EXPECT_GT(change(20 * part, 12 * side), 40) << part;
            EXPECT_GT(change(20 * side, 12 * part), 40) << part;
            EXPECT_EQ(change(20 * part, 15 * side), 0) << part;
            EXPECT_EQ(change(24 * side, 12 * part), 0) << part;
        }
    EXPECT_GT(change(0, 0), 1);  // the tint
    EXPECT_LT(change(0, 0), 40);
}

// Pixels of a line across the ring's edge that have mostly its colour.
int width_of_rim(const Picture& picture) {
    int width = 0;
    for (int x = kSize / 2 + 10; x < kSize; ++x) {
        const Colour c = mean_colour(picture, x, kSize / 2, 0);
        width += c[0] > 200 && c[1] < 150;
    }
    return width;
}

TEST_F(MarksOnGround, ring_width_is_independent_of_distance) {
    const World plane = make_world(100, 10, [](double, double) { return 0; });
    for (const double height : {30.0, 300.0, 900.0}) {
        const int width =
            width_of_rim(shot(plane, from_above({500, 500, 0}, height), with_ring({500, 500}, 0.3 * height)));
        EXPECT_GE(width, 1) << height;
        EXPECT_LE(width, 3) << height;
    }
}

TEST_F(MarksOnGround, ring_stands_between_dark_hairlines_on_white_ground) {
    World plane = make_world(40, 4, [](double, double) { return 0; });
    plane.depth.fill(1);
    Look white = plain_look();
    white.standing = {0.95f, 0.95f, 0.95f};
    Marks marks = with_ring({80, 80}, 20);
    marks.ring->colour = {1, 1, 1};
    const Picture p = draw(plane, from_above({80, 80, 0}, 60), {135, 60}, white, kSize, kSize, marks);
    double darkest_inside = 255, darkest_outside = 255;
    for (int x = 240; x < 250; ++x) darkest_inside = std::min(darkest_inside, mean_colour(p, x, 150, 0)[1]);
    for (int x = 250; x < 260; ++x) darkest_outside = std::min(darkest_outside, mean_colour(p, x, 150, 0)[1]);
    EXPECT_LT(darkest_inside, mean_colour(p, 200, 150, 3)[1] - 35);
    EXPECT_LT(darkest_outside, mean_colour(p, 280, 150, 3)[1] - 35);
}

TEST_F(MarksOnGround, contours_are_at_multiples_of_the_interval_above_the_zero_of_the_terrain) {
    World world = make_world(40, 4, [](double, double y) { return 0.5 * y; });  // 80 m: every 2 m
    world.datum = 1203.7;
    const Camera camera = from_above({80, 80, world.datum + 40}, 40);
    const Picture plain = shot(world, camera, {}), lined = shot(world, camera, with_contours());
    const auto darker = [&](double height) {  // maximum of three rows: a line may fall between two
        const glm::dvec2 at = seen_at(camera, {80, 2 * (height - world.datum), height});
        double most = 0;
        for (int row = -1; row <= 1; ++row) {
            const glm::dvec2 there = at + glm::dvec2(0, row);
            most = std::max(most, pixel(plain, there)[1] - pixel(lined, there)[1]);
        }
        return most;
    };
    for (int height = 1236; height <= 1252; height += 2) {
        EXPECT_GT(darker(height), 15) << height;
        EXPECT_EQ(darker(height + 1), 0) << height;
    }
    for (const double light : {1238, 1242, 1248, 1252}) EXPECT_GT(darker(1240), darker(light) + 10) << light;
    EXPECT_GT(darker(1250), darker(1248) + 10);
}

TEST_F(MarksOnGround, contours_are_absent_on_level_ground_at_the_height_of_a_line) {
    World level = make_world(40, 4, [](double, double) { return 0; });
    level.datum = 1200;
    const Camera camera = from_above({80, 80, 1200}, 60);
    EXPECT_TRUE(alike(shot(level, camera, {}), shot(level, camera, with_contours()), rounding()));
}

}  // namespace
}  // namespace render::test
