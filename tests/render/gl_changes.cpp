#include <algorithm>
#include <vector>

#include "tests/render/gl_scene.h"

// What a slide leaves: deposits, scars, and turf where nothing happened.
namespace render::test {
namespace {

class Changes : public Gl {
  protected:
    static constexpr int kPixels = 96;

    // Level ground under a metre of a standing layer. The west part is 0.4 m thinner than it was, the east
    // part as much thicker.
    Changes() {
        world_.depth.fill(1);
        first_depth_.assign(world_.grid.size(), 1);
        for (int y = 0; y <= 48; ++y)
            for (int x = 0; x <= 48; ++x) world_.depth(x, y) += x < 16 ? -0.4f : x > 32 ? 0.4f : 0;
    }

    Picture drawn(const Look& look, std::span<const float> first_depth) {
        renderer_->draw({.world = world_.view(),
                         .camera = from_above({96, 96, 1}, 180),
                         .light = {135, 40},
                         .look = look,
                         .width = kPixels,
                         .height = kPixels,
                         .first_depth = first_depth});
        return renderer_->read_back();
    }
    // Columns in the middle of the scar, of what never changed, and of the deposit.
    static Colour scar(const Picture& p) { return mean_colour(p, 12, 48, 8); }
    static Colour untouched(const Picture& p) { return mean_colour(p, 48, 48, 8); }
    static Colour deposit(const Picture& p) { return mean_colour(p, 84, 48, 8); }

    // Spread of the brightness around a place: how rough it looks.
    static double roughness(const Picture& p, int x) {
        double sum = 0, squares = 0, count = 0;
        for (int j = 40; j < 56; ++j)
            for (int i = x - 8; i < x + 8; ++i) {
                const double value = mean_colour(p, i, j, 0)[1];
                sum += value, squares += value * value, ++count;
            }
        return squares / count - sum / count * sum / count;
    }

    World world_ = make_world(48, 4, [](double, double) { return 0; });
    std::vector<float> first_depth_;
};

Look soil_under_turf() {
    Look look;
    look.standing = {0.22f, 0.135f, 0.07f};
    look.rolling = {0.138f, 0.089f, 0.048f};
    look.turf = glm::vec3(0.19f, 0.20f, 0.075f);
    return look;
}

TEST_F(Changes, are_rough_and_what_never_changed_looks_as_without_them) {
    const Picture before = drawn(Look(), {}), after = drawn(Look(), first_depth_);
    EXPECT_EQ(untouched(after), untouched(before));
    EXPECT_GT(roughness(after, 12), 1.5 * roughness(before, 12));
    EXPECT_GT(roughness(after, 84), 3 * roughness(before, 84));
}

TEST_F(Changes, leave_a_frame_as_it_was_if_nothing_changed) {
    const Picture unknown = drawn(Look(), {});
    std::vector<float> same;
    for (int y = 0; y <= 48; ++y)
        for (int x = 0; x <= 48; ++x) same.push_back(world_.depth(x, y));
    EXPECT_TRUE(alike(drawn(Look(), same), unknown));
    EXPECT_NE(drawn(Look(), first_depth_).pixels, unknown.pixels);
    EXPECT_TRUE(alike(drawn(Look(), {}), unknown));  // drawn earlier, it leaves no trace
}

// A slab broke off in the west: there is a metre less.
class Crown : public Changes {
  protected:
    Crown() {
        world_.depth.fill(2);
        first_depth_.assign(world_.grid.size(), 2);
        for (int y = 0; y <= 48; ++y)
            for (int x = 0; x <= 24; ++x) world_.depth(x, y) = 1;
    }
    // How much darker the darkest column at the wall is than bed and snow beside it, of 255.
    double shade(double sun_azimuth) {
        renderer_->draw({.world = world_.view(),
                         .camera = from_above({98, 96, 1}, 40),
                         .light = {sun_azimuth, 25},
                         .look = look_,
                         .width = kPixels,
                         .height = kPixels,
                         .first_depth = first_depth_});
        const Picture picture = renderer_->read_back();
        const auto column = [&](int x) {
            double sum = 0;
            for (int y = 8; y < kPixels - 8; ++y) sum += mean_colour(picture, x, y, 0)[1];
            return sum / (kPixels - 16);
        };
        double darkest = 255;
        for (int x = 12; x < kPixels - 12; ++x) darkest = std::min(darkest, column(x));
        return std::min(column(8), column(kPixels - 8)) - darkest;
    }

    Look look_;
};

TEST_F(Crown, is_in_shadow_on_the_side_away_from_the_sun) {
    EXPECT_GT(shade(90), 20);
    EXPECT_GT(shade(90), 1.5 * shade(270));
}

TEST_F(Changes, break_the_turf) {
    Look bare = soil_under_turf();
    bare.turf.reset();
    const Picture with = drawn(soil_under_turf(), first_depth_), without = drawn(bare, first_depth_);
    EXPECT_EQ(scar(with), scar(without));
    EXPECT_EQ(deposit(with), deposit(without));
    const Colour grass = untouched(with);
    EXPECT_GT(grass[1], grass[0]);
    EXPECT_TRUE(
        alike(drawn(soil_under_turf(), {}), drawn(bare, {})));  // no turf if the first depth is unknown
}

TEST_F(Changes, of_soil_differ_from_turf_by_5_in_all_colour_vision) {
    const Picture picture = drawn(soil_under_turf(), first_depth_);
    for (const Colour& changed : {scar(picture), deposit(picture)}) {
        double least = colour_distance(changed, untouched(picture));
        for (const Cone cone : kCones)
            least =
                std::min(least, colour_distance(without(cone, changed), without(cone, untouched(picture))));
        EXPECT_GT(least, 5);
    }
}

TEST_F(Changes, of_depth_end_at_no_data) {
    const Picture whole = drawn(Look(), first_depth_);
    for (int y = 0; y <= 48; ++y)
        for (int x = 22; x < 27; ++x) world_.site(x, y) = sim::Site::kDrain, world_.depth(x, y) = 0;
    const Picture with = drawn(Look(), first_depth_), without = drawn(Look(), {});
    EXPECT_EQ(mean_colour(with, 40, 48, 2), mean_colour(without, 40, 48, 2));  // untouched, beside the hole
}

// Ground without slides is shaded by a cheaper program, which must draw the same.
TEST_F(Changes, are_drawn_alike_by_both_programs) {
    World everywhere = world_;
    everywhere.rolling.fill(1e-12f);  // not to be seen, but it counts as a slide
    const auto of = [&](const World& world) {
        renderer_->draw({.world = world.view(),
                         .camera = from_above({world.side() / 2, world.side() / 2, 0}, world.side()),
                         .light = {135, 40},
                         .look = soil_under_turf(),
                         .width = 120,
                         .height = 120,
                         .first_depth = first_depth_});
        return renderer_->read_back();
    };
    const Picture some = of(world_), all = of(everywhere);
    EXPECT_TRUE(alike(some, all, 1));
}

}  // namespace
}  // namespace render::test
