#include <cmath>

#include "tests/render/gl_scene.h"
#include "tests/render/mountains.h"

// Mountains around the block, as drawn.
namespace render::test {
namespace {

class AroundTheBlock : public Gl {
  protected:
    Picture drawn(const World& world, const Camera& camera, const Light& light, const Surroundings* around,
                  int width = 160, int height = 120) {
        renderer_->draw({.world = world.view(),
                         .camera = camera,
                         .light = light,
                         .look = plain_look(),
                         .width = width,
                         .height = height,
                         .surroundings = around});
        return renderer_->read_back();
    }
};

World hills() {
    World world =
        make_world(40, 5, [](double x, double y) { return 15 * std::sin(x / 40) * std::cos(y / 30); });
    world.depth.fill(1);
    return world;
}

// The least and the greatest brightness of green in a picture, 0 to 255.
std::pair<int, int> greens(const Picture& picture) {
    int least = 255, greatest = 0;
    for (std::size_t i = 1; i < picture.pixels.size(); i += 3) {
        least = std::min<int>(least, picture.pixels[i]);
        greatest = std::max<int>(greatest, picture.pixels[i]);
    }
    return {least, greatest};
}

TEST_F(AroundTheBlock, there_is_ground_everywhere) {
    const World world = hills();
    const Surroundings around = mountains_around(world);
    // From above, with the block in the middle third: sky or a gap would be blue, ground is grey.
    const Picture with = drawn(world, from_above({100, 100, 0}, 600), {135, 80}, &around);
    for (std::size_t i = 0; i < with.pixels.size(); i += 3)
        EXPECT_LT(with.pixels[i + 2] - with.pixels[i], 40) << "pixel " << i / 3;
    const Picture without = drawn(world, from_above({100, 100, 0}, 600), {135, 80}, nullptr);
    EXPECT_GT(without.pixels[2] - without.pixels[0], 40) << "a block by itself has sky around it";
}

TEST_F(AroundTheBlock, there_is_no_gap_where_a_heap_lies_on_the_border) {
    World world = hills();
    const Surroundings around = mountains_around(world);
    for (int x = 10; x < 30; ++x) world.depth(x, 0) = 6;
    Camera camera;
    camera.target = {100, 0, 10};
    camera.azimuth_deg = 180;
    camera.elevation_deg = 12;
    camera.distance_m = 120;
    const Picture picture = drawn(world, camera, {180, 60}, &around);
    // The lower half shows ground only.
    for (int y = picture.height / 2; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const auto* p =
                &picture.pixels[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                     static_cast<std::size_t>(x))];
            EXPECT_LT(p[2] - p[0], 60) << x << " " << y;
        }
}

TEST_F(AroundTheBlock, mountains_shade_it) {
    // Hills in the west hide a sun that is low there.
    const World world = hills();
    const Surroundings around = mountains_around(world);
    const Camera camera = from_above({8, 20, 0}, 14);
    const auto green = [&](const Surroundings* with) {
        return mean_colour(drawn(world, camera, {270, 3}, with), 80, 60, 40)[1];
    };
    EXPECT_LT(green(&around), green(nullptr) - 15);
}

TEST_F(AroundTheBlock, a_frame_depends_on_its_arguments_alone) {
    const World one = hills(), other = make_strip(9, 60);
    const Surroundings around_one = mountains_around(one), around_other = mountains_around(other);
    const Camera camera = from_above({100, 100, 0}, 600);
    const Picture first = drawn(one, camera, {135, 50}, &around_one);
    drawn(other, camera, {135, 50}, &around_other);
    drawn(one, camera, {250, 20}, &around_one);
    drawn(one, camera, {135, 50}, nullptr);
    EXPECT_TRUE(alike(drawn(one, camera, {135, 50}, &around_one), first));
    EXPECT_NE(drawn(one, camera, {250, 20}, &around_one).pixels, first.pixels);
}

TEST_F(AroundTheBlock, strips_holes_and_no_ground_at_all_are_drawn) {
    const Camera camera = from_above({100, 100, 0}, 600);
    const World strip = make_strip(3, 2001);
    const Surroundings around_strip = mountains_around(strip);
    EXPECT_GT(greens(drawn(strip, camera, {135, 50}, &around_strip)).first, 40);
    World hole = hills();
    for (int y = 0; y < 41; ++y)
        for (int x = 12; x < 30; ++x) hole.site(x, y) = sim::Site::kDrain;
    const Surroundings around_hole = mountains_around(hole);
    const Picture filled = drawn(hole, camera, {135, 80}, &around_hole);
    const Colour middle = mean_colour(filled, 80, 60, 4), corner = mean_colour(filled, 10, 10, 4);
    EXPECT_LT(std::abs(middle[1] - corner[1]), 60);
    EXPECT_LT(middle[2] - middle[0], 40) << "sky is seen through the hole";
    World nothing = hills();
    nothing.site.fill(sim::Site::kDrain);
    const Surroundings none = mountains_around(nothing);
    EXPECT_TRUE(alike(drawn(nothing, camera, {135, 50}, &none), drawn(nothing, camera, {135, 50}, nullptr)));
}

}  // namespace
}  // namespace render::test
