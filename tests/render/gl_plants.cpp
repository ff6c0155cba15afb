#include <cmath>

#include "tests/render/gl_scene.h"
#include "tests/render/mountains.h"

// What grows on ground whose look has a date.
namespace render::test {
namespace {

class Plants : public Gl {
  protected:
    // Hilly ground from above on that day; none: without a date.
    Colour colour_on(std::optional<Date> date, bool surrounded = true) {
        const World world = make_world(
            60, 10, [](double x, double y) { return 40 * std::sin(x / 90) * std::cos(y / 75) + 0.2 * y; });
        const Surroundings around = mountains_around(world);
        const Land land = land_of(around);
        Look look;
        look.date = date;
        FrameInput input{world.view(), from_above({300, 300, 0}, 400), {180, 50}, look};
        input.width = input.height = 128;
        if (surrounded) input.surroundings = &around, input.land = &land;
        EXPECT_TRUE(renderer_->load(look, false));
        renderer_->draw(input);
        return mean_colour(renderer_->read_back(), 64, 64, 60);
    }
};

// How green a colour is, against its red and blue.
double green(const Colour& colour) {
    return 2 * colour[1] / (colour[0] + colour[2]);
}

TEST_F(Plants, are_green_in_july_and_straw_in_january) {
    const double summer = green(colour_on(Date{7, 15})), autumn = green(colour_on(Date{10, 5})),
                 winter = green(colour_on(Date{1, 15}));
    EXPECT_GT(summer, 1.03);
    EXPECT_GT(summer, winter + 0.05);
    EXPECT_GT(summer, autumn + 0.01);
    EXPECT_GT(autumn, winter + 0.01);
}

TEST_F(Plants, grow_on_a_block_without_mountains) {
    EXPECT_GT(green(colour_on(Date{7, 15}, false)), 1.03);
}

// Mud that flows over a meadow, its front in the middle: before it the ground is dark with water, the more, the wetter the mud.
TEST_F(Plants, are_wet_before_the_front_of_mud) {
    World world = make_world(60, 10, [](double, double y) { return 0.2 * y; });
    for (int y = 0; y <= 60; ++y)
        for (int x = 0; x <= 30; ++x) world.rolling(x, y) = 1;
    Look look;
    look.standing = {0.12f, 0.08f, 0.05f};
    look.rolling = {0.10f, 0.06f, 0.04f};
    const auto seen = [&](std::optional<Date> date, float sheen) {
        look.date = date, look.sheen = sheen;
        return draw(world, from_above({305, 300, 60}, 40), {180, 50}, look, 128, 128);
    };
    const auto brightness = [](const Picture& picture, int x) { return mean_colour(picture, x, 64, 4)[1]; };
    const std::optional<Date> july = Date{7, 15};
    const Picture dry = seen(july, 0), wet = seen(july, 1);
    double most = 0;
    for (int x = 50; x < 78; x += 4) most = std::max(most, 1 - brightness(wet, x) / brightness(dry, x));
    EXPECT_GT(most, 0.1);
    EXPECT_EQ(brightness(wet, 120), brightness(dry, 120)) << "far ahead";
    EXPECT_TRUE(alike(seen({}, 0), seen({}, 1))) << "without a date";
}

// Rain on a part of a meadow: darker there and nowhere else, in a frame of what changed as in one that is whole.
TEST_F(Plants, are_darker_where_the_soil_is_wet_and_where_a_look_has_a_date) {
    World world = make_world(60, 10, [](double, double y) { return 0.2 * y; });
    Look look;
    look.date = Date{7, 15};
    const auto seen = [&] { return draw(world, from_above({300, 300, 60}, 400), {180, 50}, look, 128, 128); };
    const auto brightness = [](const Picture& picture, int x) { return mean_colour(picture, x, 64, 12)[1]; };
    const Picture without = seen();
    world.things.emplace(world.grid);
    world.things->natural = world.bedrock;
    EXPECT_TRUE(alike(seen(), without)) << "dry";
    const auto rain = [&](float share) {
        for (int y = 0; y <= 60; ++y)
            for (int x = 35; x <= 60; ++x) world.things->water(x, y) = share;
        return seen();
    };
    rain(0.2f);
    const Picture rained = rain(1);
    EXPECT_EQ(brightness(rained, 30), brightness(without, 30));
    EXPECT_LT(brightness(rained, 100), 0.92 * brightness(without, 100));
    EXPECT_GT(brightness(rained, 100), 0.6 * brightness(without, 100));
    renderer_->forget();
    EXPECT_TRUE(alike(seen(), rained));
    look.date.reset();
    const Picture undated = seen();
    rain(0);
    EXPECT_TRUE(alike(seen(), undated)) << "without a date";
}

}  // namespace
}  // namespace render::test
