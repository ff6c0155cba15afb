#include "render/mountain/land.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "assets/shaders/slots.glsl"
#include "tests/render/mountains.h"

// What plants and water find on the ground; without GL.
namespace render::test {
namespace {

enum Part : std::uint8_t { kBrook, kMoisture, kUse, kRubble };

class Ground {
  public:
    explicit Ground(const World& world, int most_along = Land::kUsual)
        : side_(world.side()), land_(land_of(mountains_around(world), {}, most_along)) {}

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
    int tilled = 0;
    for (double y = 20; y < 300; y += 10)
        for (double x = 450; x <= 550; x += 10) tilled += ground.at(x, y, kUse) >= LAND_FIELD;
    EXPECT_GT(tilled, 100);
    for (double y = 20; y < 1000; y += 10) EXPECT_EQ(ground.at(300, y, kUse), 0) << y;
}

// A gentle slope that falls to the south, so that contours run from west to east.
Surroundings gentle_slope() {
    return mountains_around(
        make_world(100, 10, [](double, double y) { return 0.08 * y + 0.6 * std::max(y - 400, 0.0); }));
}

TEST(Land, has_fields_along_the_contour_of_many_sizes) {
    const Land land = land_of(gentle_slope());
    std::array<int, LAND_DIRECTIONS> texels{};
    std::set<int> crops;
    int all = 0;
    for (double y = 20; y < 300; y += 2)
        for (double x = 20; x < 980; x += 2)
            if (const int use = land.use({x, y}); use != 0) {
                ASSERT_LT(use, LAND_GARDEN);
                ++texels[static_cast<std::size_t>((use - LAND_FIELD) % LAND_DIRECTIONS)], ++all;
                crops.insert((use - LAND_FIELD) / LAND_DIRECTIONS);
            }
    EXPECT_GT(all, 20000);
    EXPECT_GT(crops.size(), 10u);
    EXPECT_GT(texels[0] + texels[1] + texels[LAND_DIRECTIONS - 1], 0.9 * all);
    for (double x = 20; x < 980; x += 10) EXPECT_EQ(land.use({x, 700}), 0) << "too steep";
}

TEST(Land, has_hedges_on_borders_of_fields_and_none_in_them) {
    const Land land = land_of(gentle_slope());
    std::size_t within = 0;
    for (const PlantedTree& each : land.planted) {
        EXPECT_NE(each.as, PlantedTree::As::kFruitTree) << "there is no house";
        const int here = land.use(each.at);
        const auto same = [&](double x, double y) { return land.use(each.at + glm::dvec2(x, y)) == here; };
        within += same(4, 0) && same(-4, 0) && same(0, 4) && same(0, -4);
    }
    EXPECT_GT(land.planted.size(), 200u);
    EXPECT_LT(within, land.planted.size() / 10) << "two fields in a hundred look alike";
}

TEST(Land, leads_paths_from_a_house_to_the_road_and_uphill_beside_a_garden) {
    Settlement village;
    village.houses.push_back({{500, 200}, {0, -1}, 11, 9});
    village.roads.push_back({{100, 160}, {900, 160}, 6});
    const Surroundings around = gentle_slope();
    const Land land = land_of(around, village), without = land_of(around);
    EXPECT_NE(land.fingerprint, without.fingerprint);
    const auto count = [&](const Land& of, int use, glm::dvec2 low, glm::dvec2 high) {
        int texels = 0;
        for (double y = low.y; y < high.y; ++y)
            for (double x = low.x; x < high.x; ++x) texels += of.use({x, y}) == use;
        return texels;
    };
    for (double y = 168; y < 192; y += 2) EXPECT_GT(count(land, LAND_PATH, {480, y}, {520, y + 1}), 0) << y;
    EXPECT_GT(count(land, LAND_PATH, {100, 230}, {900, 400}), 100) << "uphill";
    EXPECT_GT(count(land, LAND_VERGE, {100, 150}, {900, 170}), 5000);
    EXPECT_EQ(count(land, LAND_VERGE, {100, 180}, {900, 400}), 0);
    for (const int use : {LAND_PATH, LAND_VERGE, LAND_GARDEN})
        EXPECT_EQ(count(without, use, {0, 0}, {1000, 1000}), 0);
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
