#include <algorithm>
#include <cmath>

#include "tests/render/gl_scene.h"
#include "tests/render/mountains.h"

// Snow that wind blows off a ridge, in the image.
namespace render::test {
namespace {

class DrawnSpindrift : public Gl {
  protected:
    static constexpr int kPixels = 160;

    DrawnSpindrift() {
        world_.depth.fill(1);
        around_ = mountains_around(world_);
        look_.standing = {0.86f, 0.89f, 0.93f};
        look_.powder.strength = 1;
    }
    // A camera in the west, along the ridge, so that the wind blows across the image.
    Picture drawn(const Wind& wind, double seconds = 0, double azimuth = 260, double elevation = 5,
                  const Marks& marks = {}) {
        renderer_->draw({.world = world_.view(),
                         .camera = {{500, 500, 115}, azimuth, elevation, 420, 50},
                         .light = {200, 30},
                         .look = look_,
                         .marks = marks,
                         .width = kPixels,
                         .height = kPixels,
                         .surroundings = &around_,
                         .wind = wind,
                         .seconds = seconds});
        return renderer_->read_back();
    }

    World world_ =
        make_world(100, 10, [](double, double y) { return std::max(0.0, 120 - 0.6 * std::abs(y - 500)); });
    Surroundings around_;
    Look look_;
    static constexpr Wind kWind{.from_deg = 0, .speed = 12};
};

TEST_F(DrawnSpindrift, shows_in_wind_only_and_leaves_nothing_behind) {
    const Picture calm = drawn({});
    EXPECT_GT(differing(drawn(kWind), calm), 100);
    EXPECT_TRUE(alike(drawn({}), calm));
}

TEST_F(DrawnSpindrift, moves_with_the_time_of_the_world_and_depends_on_nothing_else) {
    const Picture first = drawn(kWind, 10), later = drawn(kWind, 14);
    EXPECT_GT(differing(first, later), 50);
    EXPECT_TRUE(alike(drawn(kWind, 10), first));
    EXPECT_TRUE(alike(drawn(kWind, 14), later));
}

TEST_F(DrawnSpindrift, does_not_jump_within_a_tick) {
    for (const double at : {0.0, 7.3, 36000.0}) {
        const Picture before = drawn(kWind, at), after = drawn(kWind, at + 1 / 60.);
        EXPECT_TRUE(alike(before, after, 15)) << at;
    }
}

TEST_F(DrawnSpindrift, is_dry_snow_and_neither_wet_nor_soil_and_hidden_by_an_overlay) {
    look_.powder.strength = 0.25f;
    EXPECT_TRUE(alike(drawn(kWind), drawn({})));
    look_.powder.strength = 1;
    look_.standing = {0.22f, 0.135f, 0.07f};
    EXPECT_TRUE(alike(drawn(kWind), drawn({})));
    look_.standing = {0.86f, 0.89f, 0.93f};
    Marks marks;
    marks.overlay = Overlay::kSlope;
    EXPECT_TRUE(alike(drawn(kWind, 0, 260, 5, marks), drawn({}, 0, 260, 5, marks)));
}

TEST_F(DrawnSpindrift, hides_behind_the_ground) {
    // From below on the windward side what blows off the lee is behind the ridge.
    const auto seen_from = [&](double from_deg) {
        return differing(drawn({from_deg, 12}, 0, 180, -12), drawn({}, 0, 180, -12));
    };
    EXPECT_LT(2 * seen_from(135), seen_from(45));
}

}  // namespace
}  // namespace render::test
