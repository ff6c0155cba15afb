#include <array>
#include <cmath>

#include "render/gl/context.h"
#include "tests/render/gl_scene.h"

// How much of the ground a thin cover hides.
namespace render::test {
namespace {

// Slopes whose cover varies around the depth at which it hides the ground, slowly and within a few cells.
World thinly_covered(int squares) {
    constexpr double kSide = 480;
    World world = make_world(squares, static_cast<float>(kSide / squares),
                             [](double x, double y) { return 40 * std::sin(x / 60) * std::cos(y / 75); });
    for (int y = 0; y <= squares; ++y)
        for (int x = 0; x <= squares; ++x) {
            const double east = x * kSide / squares, north = y * kSide / squares;
            world.depth(x, y) = static_cast<float>(0.05 * (0.8 + 0.25 * std::sin(east / 50 + 1) +
                                                           0.3 * std::sin(north / 21) * std::cos(east / 17)));
        }
    return world;
}

// Share of white, 0 to 1, of the whole ground; bare ground and cover by themselves give the scale.
class Cover : public Gl {
  protected:
    double share(const World& world, int pixels) {
        return (brightness(world, pixels, 0.05f) - brightness(world, pixels, 10)) /
               (brightness(world, pixels, 0.001f) - brightness(world, pixels, 10));
    }

  private:
    double brightness(const World& world, int pixels, float visible_m) {
        Look look;
        look.standing = glm::vec3(0.8f);
        look.rock = look.meadow = glm::vec3(0.02f);
        look.cover_visible_m = visible_m;
        const Picture p = draw(world, from_above({240, 240, 0}, 440), {135, 60}, look, pixels, pixels);
        return mean_colour(p, pixels / 2, pixels / 2, pixels / 2 - 2)[1];
    }
};

TEST_F(Cover, hides_the_same_share_at_any_resolution) {
    const World world = thinly_covered(96);
    const double whole = share(world, 384);
    EXPECT_GT(whole, 0.2);
    EXPECT_LT(whole, 0.8);
    // From far details are means of texels, which a GPU takes otherwise: 0.058 on one.
    const double most = is_software_renderer() ? 0.02 : 0.07;
    for (const int pixels : {96, 192, 768}) EXPECT_NEAR(share(world, pixels), whole, most) << pixels;
}

// Level ground, beyond it a slope of 60 degrees; all bare.
TEST_F(Cover, shows_old_snow_on_bare_ground_that_is_not_steep) {
    const World world = make_world(48, 10, [](double x, double) { return 1.7 * std::max(0.0, x - 240); });
    Look look;
    look.standing = glm::vec3(0.8f);
    look.rock = look.meadow = glm::vec3(0.02f);
    const auto brightness = [&](float old_cover_m, int x) {
        look.old_cover_m = old_cover_m;
        return mean_colour(draw(world, from_above({240, 240, 400}, 440), {270, 60}, look, 100, 100), x, 50,
                           10)[1];
    };
    EXPECT_GT(brightness(0.8f, 25), brightness(0, 25) + 60);
    EXPECT_NEAR(brightness(0.8f, 75), brightness(0, 75), 3);
}

TEST_F(Cover, hides_the_same_share_on_any_grid) {
    const double usual = share(thinly_covered(160), 384);
    for (const int squares : {80, 320, 512})
        EXPECT_NEAR(share(thinly_covered(squares), 384), usual, 0.02) << squares;
}

}  // namespace
}  // namespace render::test
