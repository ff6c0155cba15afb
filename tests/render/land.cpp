#include "render/mountain/land.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "assets/shaders/slots.glsl"
#include "tests/render/mountains.h"

// What plants and water find on the ground; without GL.
namespace render::test {
namespace {

enum Part : std::uint8_t { kBrook, kMoisture, kTilled, kRubble };

class Ground {
  public:
    explicit Ground(const World& world, int most_along = Land::kUsual)
        : side_(world.side()), land_(land_of(mountains_around(world), most_along)) {}

    // A part at a place, m, 0 to 255.
    int at(double x, double y, Part part) const {
        const auto column = static_cast<std::size_t>(std::lround(x / side_ * (land_.columns - 1))),
                   row = static_cast<std::size_t>(std::lround(y / side_ * (land_.rows - 1)));
        return land_.texels[4 * (row * static_cast<std::size_t>(land_.columns) + column) + part];
    }
    // How far the water of a brook is away, m, below 0 in it.
    double to_brook(double x, double y) const {
        return LAND_FAR - (LAND_FAR + LAND_NEAR) * at(x, y, kBrook) / 255;
    }
    const Land& land() const { return land_; }

  private:
    double side_;
    Land land_;
};

// A valley that falls to the south, 1 km wide and long, between slopes of 30 degrees, with its floor at x = 500.
double valley_to_south(double x, double y) {
    return 0.58 * std::max(std::abs(x - 500) - 60, 0.0) + 0.08 * std::abs(x - 500) + 0.05 * y;
}

TEST(Land, has_a_brook_where_water_gathers_and_none_above) {
    const Ground ground(make_world(100, 10, valley_to_south));
    const auto nearest = [&](double y) {
        double least = LAND_FAR;
        for (double x = 440; x <= 560; x += 2) least = std::min(least, ground.to_brook(x, y));
        return least;
    };
    for (const double y : {100.0, 300.0, 500.0}) EXPECT_LT(nearest(y), 0) << y;
    EXPECT_EQ(ground.to_brook(500, 960), LAND_FAR);  // too little drains there
    for (double y = 50; y < 1000; y += 50) {
        EXPECT_EQ(ground.to_brook(250, y), LAND_FAR) << y;
        EXPECT_EQ(ground.to_brook(750, y), LAND_FAR) << y;
    }
}

TEST(Land, is_moist_in_a_valley_and_tilled_where_it_is_low_and_gentle) {
    const Ground ground(make_world(100, 10, valley_to_south));
    EXPECT_GT(ground.at(500, 300, kMoisture), ground.at(300, 300, kMoisture) + 60);
    EXPECT_GT(ground.at(500, 200, kTilled), 200);
    EXPECT_EQ(ground.at(300, 200, kTilled), 0);
}

TEST(Land, has_rubble_under_rock_only) {
    // A cliff between a shelf and a slope.
    const Ground ground(make_world(100, 10, [](double, double y) {
        return y < 600 ? 0.5 * y : 300 + 2 * std::min(y - 600, 60.0) + 0.1 * std::max(y - 660, 0.0);
    }));
    EXPECT_GT(ground.at(500, 580, kRubble), 150);
    EXPECT_LT(ground.at(500, 300, kRubble), 20);
    EXPECT_EQ(ground.at(500, 900, kRubble), 0);
}

TEST(Land, shows_the_same_brooks_on_any_grid_and_in_a_page) {
    const Ground fine(make_world(200, 5, valley_to_south)), coarse(make_world(100, 10, valley_to_south)),
        page(make_world(100, 10, valley_to_south), Land::kInPages);
    for (double y = 100; y < 500; y += 50) {
        EXPECT_LT(fine.to_brook(500, y), 26) << y;
        EXPECT_LT(std::abs(coarse.to_brook(500, y) - page.to_brook(500, y)), 2.5) << y;
    }
    EXPECT_LE(page.land().columns, Land::kInPages);
}

// Every second vertex is a pit; a lake basin has no way out; one row of vertices is a plane.
TEST(Land, ends_on_ground_full_of_pits) {
    const Ground pits(make_world(60, 10, [](double x, double y) {
        return std::remainder(std::floor(x / 10) + std::floor(y / 10), 2) == 0 ? 0.0 : -30.0;
    }));
    const Ground basin(
        make_world(60, 10, [](double x, double y) { return 0.3 * std::hypot(x - 300, y - 300); }));
    const Ground level(make_world(8, 10, [](double, double) { return 0.0; }));
    for (const Ground* ground : {&pits, &basin, &level})
        EXPECT_EQ(ground->land().texels.size(), 4u * static_cast<unsigned>(ground->land().columns) *
                                                    static_cast<unsigned>(ground->land().rows));
}

}  // namespace
}  // namespace render::test
