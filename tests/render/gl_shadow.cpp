#include <cmath>

#include "tests/render/gl_scene.h"

namespace render::test {
namespace {

// Level ground with a ridge 20 m high and one cell wide at the foot, along y at x = 160.
World with_ridge() {
    World world = make_world(80, 4, [](double x, double) { return std::abs(x - 160) < 2 ? 20 : 0; });
    world.depth.fill(0.5f);
    return world;
}

// The same along x.
World with_ridge_across() {
    World world = make_world(80, 4, [](double, double y) { return std::abs(y - 160) < 2 ? 20 : 0; });
    world.depth.fill(0.5f);
    return world;
}

class Shadow : public Gl {
  protected:
    // Green of the ground at a place, seen from above.
    double green(const World& world, const Light& light, double x, double y) {
        return mean_colour(draw(world, from_above({x, y, 0.5}, 12), light, plain_look()), 48, 48, 3)[1];
    }
    double lit(const World& world, const Light& light) { return green(world, light, 40, 40); }
};

TEST_F(Shadow, is_as_long_as_the_ridge_is_high_over_the_tangent_of_the_sun) {
    const Light west{270, 30};
    const double length = 20 / std::tan(30 * 3.14159265358979 / 180);  // 34.6 m
    EXPECT_LT(green(with_ridge(), west, 160 + length - 6, 160), 0.7 * lit(with_ridge(), west));
    EXPECT_GT(green(with_ridge(), west, 160 + length + 6, 160), 0.97 * lit(with_ridge(), west));
    // Beside the ridge a part of the sky is hidden.
    EXPECT_GT(green(with_ridge(), west, 160 - 12, 160), 0.92 * lit(with_ridge(), west));
}

TEST_F(Shadow, falls_away_from_the_sun_on_all_four_sides) {
    const double length = 20 / std::tan(40 * 3.14159265358979 / 180);  // 23.8 m
    struct Case {
        World world;
        double sun_deg, x, y;
    };
    const Case cases[] = {{with_ridge(), 270, 1, 0},
                          {with_ridge(), 90, -1, 0},
                          {with_ridge_across(), 180, 0, 1},
                          {with_ridge_across(), 0, 0, -1}};
    for (const auto& [world, sun_deg, x, y] : cases) {
        const Light light{sun_deg, 40};
        const double inside = length - 6, outside = length + 6;
        EXPECT_LT(green(world, light, 160 + inside * x, 160 + inside * y), 0.75 * lit(world, light))
            << sun_deg;
        EXPECT_GT(green(world, light, 160 + outside * x, 160 + outside * y), 0.97 * lit(world, light))
            << sun_deg;
        EXPECT_GT(green(world, light, 160 - 12 * x, 160 - 12 * y), 0.92 * lit(world, light)) << sun_deg;
    }
}

TEST_F(Shadow, of_a_slanting_sun_keeps_its_length_along_the_light) {
    const Light southwest{250, 30};  // 20° from the ridge's normal
    const double across =
        20 / std::tan(30 * 3.14159265358979 / 180) * std::cos(20 * 3.14159265358979 / 180);  // 32.6 m
    EXPECT_LT(green(with_ridge(), southwest, 160 + across - 6, 160), 0.7 * lit(with_ridge(), southwest));
    EXPECT_GT(green(with_ridge(), southwest, 160 + across + 6, 160), 0.97 * lit(with_ridge(), southwest));
}

TEST_F(Shadow, is_also_cast_by_a_heap_of_rolling_material) {
    World world = make_world(80, 4, [](double, double) { return 0; });
    world.depth.fill(0.5f);
    for (int y = 0; y <= 80; ++y) world.rolling(40, y) = 20;
    const Light west{270, 30};
    EXPECT_LT(green(world, west, 160 + 26, 160), 0.7 * lit(world, west));
}

TEST_F(Shadow, is_absent_on_level_ground_at_any_sun_elevation) {
    World world = make_world(80, 4, [](double, double) { return 0; });
    world.depth.fill(0.5f);
    const Light low{215, 3};
    EXPECT_NEAR(green(world, low, 300, 300), lit(world, low), 1);
}

}  // namespace
}  // namespace render::test
