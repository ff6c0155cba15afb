#include "render/mountain/spindrift.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/render/mountains.h"

// Which ridges smoke in wind; without GL.
namespace render::test {
namespace {

// From west to east a ridge of a kilometre, 120 m high.
double ridge(double, double y) {
    return std::max(0.0, 120 - 0.6 * std::abs(y - 500));
}

constexpr Wind kAcross{.from_deg = 0, .speed = 10}, kAlong{.from_deg = 90, .speed = 10};

class SnowyRidge : public testing::Test {
  protected:
    explicit SnowyRidge(double (*shape)(double, double) = ridge) : world(make_world(100, 10, shape)) {
        world.depth.fill(1);
    }
    std::vector<SpindriftPlace> on_grid(const Wind& wind) const {
        const Ridges ridges(mountains_around(world), wind);
        std::vector<SpindriftPlace> inside;
        for (const SpindriftPlace& place : ridges.places())
            if (std::min(place.at.x, place.at.y) > 0 && std::max(place.at.x, place.at.y) < 1000)
                inside.push_back(place);
        return inside;
    }

    World world;
};

TEST_F(SnowyRidge, smokes_along_its_crest_in_wind_across_it) {
    const auto places = on_grid(kAcross);
    EXPECT_GT(places.size(), 50u);
    for (const SpindriftPlace& place : places) {
        EXPECT_NEAR(place.at.y, 500, 1);
        EXPECT_NEAR(place.at.z, 121, 1);
        EXPECT_GT(place.strength, 0);
        EXPECT_LE(place.strength, 1);
    }
}

TEST_F(SnowyRidge, does_not_smoke_in_wind_along_it_nor_in_a_calm) {
    EXPECT_TRUE(on_grid(kAlong).empty());
    EXPECT_TRUE(on_grid({}).empty());
    EXPECT_TRUE(on_grid({.from_deg = 0, .speed = Ridges::kLeastSpeed}).empty());
}

TEST_F(SnowyRidge, smokes_more_in_more_wind) {
    const auto weak = on_grid({.from_deg = 0, .speed = 6}), strong = on_grid({.from_deg = 0, .speed = 12});
    ASSERT_EQ(weak.size(), strong.size());
    for (std::size_t i = 0; i < weak.size(); ++i) EXPECT_LT(weak[i].strength, strong[i].strength);
}

TEST_F(SnowyRidge, without_snow_does_not_smoke) {
    world.depth.fill(0);
    EXPECT_TRUE(on_grid(kAcross).empty());
}

TEST_F(SnowyRidge, is_no_slope_and_no_level_ground) {
    world = make_world(100, 10, [](double, double y) { return 0.5 * y; });
    world.depth.fill(1);
    EXPECT_TRUE(on_grid(kAcross).empty());
    world = make_world(100, 10, [](double, double) { return 3.0; });
    world.depth.fill(1);
    EXPECT_TRUE(on_grid(kAcross).empty());
}

TEST_F(SnowyRidge, has_the_same_places_each_time_and_no_more_than_the_limit) {
    world = make_world(400, 10, [](double, double y) { return 40 * std::abs(std::sin(y / 40)); });
    world.depth.fill(1);
    const Surroundings around = mountains_around(world);
    const Ridges one(around, kAcross), two(around, kAcross);
    ASSERT_EQ(one.places().size(), Ridges::kMost);
    ASSERT_EQ(two.places().size(), Ridges::kMost);
    EXPECT_EQ(std::memcmp(one.places().data(), two.places().data(), one.places().size_bytes()), 0);
}

TEST_F(SnowyRidge, is_lit_unless_a_mountain_hides_the_sun) {
    world = make_world(100, 10, [](double x, double y) { return std::max(ridge(x, y), 4 * (y - 700)); });
    world.depth.fill(1);
    const Surroundings around = mountains_around(world);
    Ridges ridges(around, {.from_deg = 180, .speed = 10});
    const auto lit = [&](const glm::vec3& sun) {
        ridges.light(around, glm::normalize(sun));
        float sum = 0, count = 0;
        for (const SpindriftPlace& place : ridges.places())
            if (std::abs(place.at.y - 500) < 5 && std::abs(place.at.x - 500) < 300)
                sum += place.sunlit, ++count;
        return sum / count;
    };
    EXPECT_GT(lit({0, -1, 0.4}), 0.9f);
    EXPECT_LT(lit({0, 1, 0.4}), 0.1f);
}

}  // namespace
}  // namespace render::test
