#include <cmath>

#include "render/view/sky_light.h"
#include "tests/render/gl_scene.h"

namespace render::test {
namespace {

class Colours : public Gl {
  protected:
    // A gentle slope: a standing layer on its west half, and a rolling layer on top of one on its east half.
    static World half_rolling() {
        World world = make_world(40, 4, [](double, double y) { return 0.4 * y; });
        world.depth.fill(0.6f);
        for (int y = 0; y <= 40; ++y) {
            for (int x = 21; x <= 40; ++x) world.rolling(x, y) = 0.8f;
        }
        return world;
    }

    // The smallest colour distance between the two halves, over all kinds of colour vision.
    double apart(const Look& look, double sun_azimuth_deg) {
        const Picture p = draw(half_rolling(), from_above({80, 80, 32}, 120), {sun_azimuth_deg, 35}, look);
        const Colour standing = mean_colour(p, 20, 48, 14), rolling = mean_colour(p, 76, 48, 14);
        double least = colour_distance(standing, rolling);
        for (const Cone cone : kCones)
            least = std::min(least, colour_distance(without(cone, standing), without(cone, rolling)));
        return least;
    }
};

Look soil_look() {
    Look look;
    look.standing = {0.22f, 0.135f, 0.07f};
    look.rolling = {0.46f, 0.29f, 0.14f};
    return look;
}

TEST_F(Colours, a_level_plane_has_the_colour_computed_by_hand) {
    World plane = make_world(40, 4, [](double, double) { return 0; });
    plane.depth.fill(1);
    for (const double elevation_deg : {15.0, 40.0}) {
        const Picture p = draw(plane, from_above({80, 80, 1}, 8), {135, elevation_deg}, plain_look());
        // light.glsl: albedo · (sun · n·l + sky), n·l the sine of the sun's elevation on level ground. Smooth
        // cover hides 5 % of the sky from itself (terrain.frag).
        const double n_l = std::sin(elevation_deg * 3.14159265358979 / 180);
        const SkyLight light = sky_light(elevation_deg);
        const Colour seen = mean_colour(p, 48, 48, 10);
        for (int c = 0; c < 3; ++c) {
            const double linear = 0.5 * (light.lamp[c] * n_l + 0.95 * light.above[c]);
            ASSERT_LT(linear, 0.6);  // below the knee of the tone curve
            EXPECT_NEAR(seen[static_cast<std::size_t>(c)], 255 * (1.055 * std::pow(linear, 1 / 2.4) - 0.055),
                        1.5)
                << elevation_deg << ", " << c;
        }
    }
}

TEST_F(Colours, a_slope_that_faces_the_sun_is_lit_by_the_cosine_between_them_with_contrast) {
    World slope = make_world(40, 4, [](double x, double) { return 0.5 * x; });  // faces west
    slope.depth.fill(1);
    const Picture p = draw(slope, from_above({80, 80, 41}, 8), {270, 30}, plain_look());
    const double n_z = 1 / std::sqrt(1.25), n_l = n_z * (0.5 * std::cos(0.5235988) + std::sin(0.5235988));
    // The sky is brighter on the sun's side: half of the cosine between their horizontal parts.
    const double up = 0.5 + 0.5 * n_z, aside = 0.5 * n_z * std::cos(0.5235988);
    const SkyLight light = sky_light(30);
    const double sky = light.above.r * (1 + 0.5 * aside);
    // It is drawn with more contrast to level ground than it has.
    const double drawn = n_l * (1 + 0.75 * light.openness_contrast * (n_l - 0.5));
    const double red = 0.5 * (light.lamp.r * drawn + light.below.r + (sky - light.below.r) * up);
    const double knee = red < 0.6 ? red : 0.6 + 0.4 * (1 - std::pow(1 + (red - 0.6) / 1.6, -4));
    // The plane's own horizon hides a little of the sky.
    EXPECT_NEAR(mean_colour(p, 48, 48, 10)[0], 255 * (1.055 * std::pow(knee, 1 / 2.4) - 0.055), 3);
}

TEST_F(Colours, at_dusk_a_slope_toward_the_glow_is_lighter_and_warmer_than_one_away_from_it) {
    World slope = make_world(40, 4, [](double x, double) { return 0.5 * x; });  // faces west
    const Camera camera = from_above({80, 80, 41}, 8);
    slope.depth.fill(1);
    const auto toward = mean_colour(draw(slope, camera, {270, -3}, plain_look()), 48, 48, 10),
               away = mean_colour(draw(slope, camera, {90, -3}, plain_look()), 48, 48, 10);
    EXPECT_GT(toward[0], away[0] + 10);
    EXPECT_GT(toward[0] - toward[2], away[0] - away[2] + 10);
}

TEST_F(Colours, a_small_hollow_is_darker_than_the_slope_beside_it_under_a_high_sun) {
    // A trough down the slope, two cells wide and too shallow to hide the sky.
    World slope = make_world(
        40, 4, [](double x, double y) { return 0.5 * y - 1.5 * std::exp(-(x - 80) * (x - 80) / 32); });
    slope.depth.fill(1);
    const auto at = [&](double x) {
        return mean_colour(draw(slope, from_above({x, 80, 41}, 8), {180, 60}, plain_look()), 48, 48, 6);
    };
    EXPECT_LT(at(80)[0], at(40)[0] - 6);
}

TEST_F(Colours, rolling_snow_differs_from_standing_snow_by_10_in_all_colour_vision) {
    for (const double sun : {90.0, 180.0, 270.0}) EXPECT_GT(apart(Look(), sun), 10) << sun;
}

TEST_F(Colours, rolling_soil_differs_from_standing_soil_by_10_in_all_colour_vision) {
    for (const double sun : {90.0, 180.0, 270.0}) EXPECT_GT(apart(soil_look(), sun), 10) << sun;
}

TEST_F(Colours, a_cover_hides_the_ground_from_its_visible_depth_and_not_below_half_of_it) {
    Look look = plain_look();
    look.cover_visible_m = 0.2f;
    World world = make_world(40, 4, [](double, double) { return 0; });
    const auto shown = [&](float depth) {
        world.depth.fill(depth);
        return mean_colour(draw(world, from_above({80, 80, 0}, 8), {135, 40}, look), 48, 48, 10);
    };
    EXPECT_LT(colour_distance(shown(0.09f), shown(0)), 0.5);
    EXPECT_LT(colour_distance(shown(0.21f), shown(1)), 0.5);
    EXPECT_GT(colour_distance(shown(0.09f), shown(0.21f)), 20);
}

// Pure lower material looks as it would alone, and a mixture lies between.
TEST_F(Colours, of_two_materials_are_those_of_the_visible_mixture) {
    Look snow, soil = soil_look();
    snow.lower_standing = soil.standing, snow.lower_rolling = soil.rolling;
    const auto drawn = [&](const World& world, const Look& look) {
        return draw(world, from_above({80, 80, 32}, 120), {180, 35}, look);
    };
    World world = half_rolling();
    const Picture white = drawn(world, snow), brown = drawn(world, soil);
    world.mixture = sim::Mixture{
        {}, sim::Field<float>(world.grid), sim::Field<float>(world.grid), sim::Field<float>(world.grid), {}};
    EXPECT_TRUE(alike(drawn(world, snow), white));
    world.mixture->untouched = world.depth;
    world.mixture->rolling = world.rolling;
    EXPECT_TRUE(alike(drawn(world, snow), brown));
    for (int y = 0; y <= 40; ++y)
        for (int x = 0; x <= 40; ++x) {
            world.mixture->untouched(x, y) = 0;
            world.mixture->settled(x, y) = world.depth(x, y) / 2;
            world.mixture->rolling(x, y) = world.rolling(x, y) / 2;
        }
    const Picture mixed = drawn(world, snow);
    for (const int x : {20, 76}) {
        const Colour whites = mean_colour(white, x, 48, 14), browns = mean_colour(brown, x, 48, 14),
                     both = mean_colour(mixed, x, 48, 14);
        EXPECT_LT(both[2], whites[2]);
        EXPECT_GT(both[2], browns[2]);
    }
}

}  // namespace
}  // namespace render::test
