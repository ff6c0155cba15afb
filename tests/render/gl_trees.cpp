#include <cmath>

#include "tests/render/gl_scene.h"
#include "tests/render/mountains.h"

// Trees in the image.
namespace render::test {
namespace {

class DrawnTrees : public Gl {
  protected:
    static constexpr int kPixels = 96;

    DrawnTrees() {
        around_ = mountains_around(world_);
        woods_ = Woods(around_, {.density = 400, .line_m = 400, .seed = 3}, 0);
        look_ = plain_look();
    }
    Picture drawn(const Woods* woods, const Surroundings* around, const Marks& marks = {}) {
        EXPECT_TRUE(renderer_->load(look_, false));
        renderer_->draw({.world = world_.view(),
                         .camera = {{300, 300, 60}, 180, 15, 500, 40},
                         .light = {240, 30},
                         .look = look_,
                         .marks = marks,
                         .width = kPixels,
                         .height = kPixels,
                         .surroundings = around,
                         .woods = woods});
        return renderer_->read_back();
    }

    World world_ = make_world(60, 10, [](double, double y) { return 0.35 * y; });
    Surroundings around_;
    Woods woods_;
    Look look_;
};

TEST_F(DrawnTrees, change_the_frame_and_leave_nothing_behind) {
    const Picture without = drawn(nullptr, &around_);
    EXPECT_GT(differing(drawn(&woods_, &around_), without), 300);
    EXPECT_TRUE(alike(drawn(nullptr, &around_), without));
    const Woods none;
    EXPECT_TRUE(alike(drawn(&none, &around_), without));
}

TEST_F(DrawnTrees, are_none_in_a_model_and_under_an_overlay) {
    EXPECT_TRUE(alike(drawn(&woods_, nullptr), drawn(nullptr, nullptr)));
    Marks marks;
    marks.overlay = Overlay::kSlope;
    EXPECT_TRUE(alike(drawn(&woods_, &around_, marks), drawn(nullptr, &around_, marks)));
}

TEST_F(DrawnTrees, are_darker_than_snow_and_white_where_snow_lies) {
    const auto mean = [&](const Picture& picture) {
        return mean_colour(picture, kPixels / 2, kPixels / 2, 20)[1];
    };
    look_.standing = {0.86f, 0.89f, 0.93f};
    world_.depth.fill(1);
    around_ = mountains_around(world_);
    const Woods in_snow(around_, {.density = 400, .line_m = 400, .seed = 3}, 0);
    const double snow = mean(drawn(nullptr, &around_)), trees = mean(drawn(&in_snow, &around_));
    EXPECT_LT(trees, snow - 10);
    look_.standing = {0.2f, 0.13f, 0.07f};
    EXPECT_LT(mean(drawn(&in_snow, &around_)), trees - 10);
}

TEST_F(DrawnTrees, of_a_closed_wood_are_as_dark_from_far_as_from_near) {
    look_.standing = {0.86f, 0.89f, 0.93f};
    world_.depth.fill(1);
    around_ = mountains_around(world_);
    const Woods wood(around_, {.density = 400, .line_m = 400, .seed = 3}, 0);
    // Without haze a frame of the same part of the wood is as bright, whatever the distance.
    const auto mean = [&](double distance) {
        const double opening = 2 * std::atan(60 / distance) * 57.2958;
        renderer_->draw({.world = world_.view(),
                         .camera = {{300, 300, 105}, 180, 15, distance, opening},
                         .light = {240, 30},
                         .look = look_,
                         .width = 64,
                         .height = 64,
                         .surroundings = &around_,
                         .woods = &wood});
        return mean_colour(renderer_->read_back(), 32, 32, 24)[1];
    };
    const double near = mean(500);
    EXPECT_LT(near, 150);
    EXPECT_NEAR(mean(700), near, 15);
    EXPECT_NEAR(mean(1000), near, 15);
}

TEST_F(DrawnTrees, are_green_in_summer_gold_in_autumn_and_bare_in_winter) {
    world_.depth.fill(0);
    around_ = mountains_around(world_);
    TreeRules rules{.density = 700, .line_m = 900, .seed = 3};
    const Picture without_date = [&] {
        const Woods winter(around_, rules, 0);
        return drawn(&winter, &around_);
    }();
    rules.mixed = true;
    const Woods mixed(around_, rules, 0);
    const auto on = [&](Date date) {
        look_.date = date;
        return drawn(&mixed, &around_);
    };
    const auto colour = [&](const Picture& picture) {
        return mean_colour(picture, kPixels / 2, kPixels / 2, 20);
    };
    const Picture summer = on({7, 15}), autumn = on({10, 20}), winter = on({12, 20});
    EXPECT_GT(differing(summer, without_date), 300);
    EXPECT_GT(colour(summer)[1], colour(summer)[0] + 5) << "green";
    EXPECT_GT(colour(autumn)[0], colour(autumn)[1] + 5) << "red and gold";
    EXPECT_LT(std::abs(colour(winter)[0] - colour(winter)[1]), 12) << "grey";
    EXPECT_TRUE(alike(on({7, 15}), summer));
    look_.date.reset();
    const Woods before(around_, {.density = 700, .line_m = 900, .seed = 3}, 0);
    EXPECT_TRUE(alike(drawn(&before, &around_), without_date));
}

}  // namespace
}  // namespace render::test
