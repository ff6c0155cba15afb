#include "terrains/generate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/terrains/files.h"

namespace terrains {
namespace {

// The bare formula: no sway, relief or hollow.
SoilSlope plain_slope() {
    SoilSlope recipe;
    recipe.sway = recipe.relief = recipe.hollow = 0;
    return recipe;
}

float at(const Terrain& terrain, const std::vector<float>& field, double x, double y) {
    const auto i = static_cast<std::size_t>(std::lround(x / terrain.grid.dx));
    const auto j = static_cast<std::size_t>(std::lround(y / terrain.grid.dx));
    return field[j * terrain.grid.nx + i];
}

TEST(SoilSlope, matches_its_formula) {
    const auto terrain = generate_soil_slope(plain_slope()).value();
    EXPECT_EQ(terrain.grid, (sim::Grid{81, 81, 2.f}));
    // At the break the logarithm is 0: −100 (tan 32° + tan 3°) / 2.
    EXPECT_NEAR(at(terrain, terrain.surface, 80, 60), -33.8639, 1e-3);
    // Far above it the slope is tan 32°: 40 m · 0.624869.
    EXPECT_NEAR(at(terrain, terrain.surface, 80, 160) - at(terrain, terrain.surface, 80, 120), 24.9948, 2e-3);
    // Far below it tan 3°: 20 m · 0.052408.
    EXPECT_NEAR(at(terrain, terrain.surface, 80, 20) - at(terrain, terrain.surface, 80, 0), 1.0482, 2e-3);
    // Six metres below the break the soil is half the slope's plus all of the foot's.
    EXPECT_NEAR(at(terrain, terrain.cover, 80, 54), 0.45 + 0.1, 1e-3);
    EXPECT_NEAR(at(terrain, terrain.cover, 80, 150), 0.9 + 0.1, 1e-3);
}

TEST(SoilSlope, falls_to_the_south_from_the_heap) {
    const auto terrain = generate_soil_slope().value();
    const double slope = (at(terrain, terrain.surface, 80, 144) - at(terrain, terrain.surface, 80, 132)) / 12;
    EXPECT_NEAR(std::atan(slope) * 180 / 3.14159265, 32, 1.5);
}

TEST(AlpineValley, starts_steep_at_the_heap_and_runs_out_flat) {
    const auto terrain = generate_alpine_valley().value();
    EXPECT_EQ(terrain.grid, (sim::Grid{161, 161, 12.5f}));
    const auto degrees = [&](double high, double low) {
        return std::atan((test::height_at(terrain, {960, high}) - test::height_at(terrain, {960, low})) /
                         (high - low)) *
               180 / 3.14159265;
    };
    EXPECT_GT(degrees(1720, 1600), 35);
    EXPECT_LT(degrees(1720, 1600), 42);
    EXPECT_LT(degrees(660, 560), 15);
}

TEST(AlpineValley, holds_the_heap_in_a_bowl) {
    const auto terrain = generate_alpine_valley().value();
    for (const double away : {100.0, 150.0, 200.0}) {
        EXPECT_GT(test::height_at(terrain, {960 - away, 1670}),
                  test::height_at(terrain, {960, 1670}) + away / 20);
        EXPECT_GT(test::height_at(terrain, {960 + away, 1670}),
                  test::height_at(terrain, {960, 1670}) + away / 20);
    }
}

TEST(AlpineValley, puts_snow_only_on_gentle_ground) {
    const auto terrain = generate_alpine_valley().value();
    EXPECT_GT(at(terrain, terrain.cover, 962.5, 1675), 0.9f);
    EXPECT_EQ(at(terrain, terrain.cover, 1000, 500), 0.f);  // the valley floor
    for (const float cover : terrain.cover) EXPECT_TRUE(cover >= 0 && cover <= 1.2f + 1e-3f);
}

TEST(AlpineValley, has_an_opposite_side_with_a_skyline) {
    const auto terrain = generate_alpine_valley().value();
    const auto south = terrain.surface.begin();
    const auto [low, high] = std::minmax_element(south, south + terrain.grid.nx);
    EXPECT_GT(*low, 1300);
    EXPECT_GT(*high - *low, 100);
}

template <class Generate>
void expect_one_mountain(Generate generate) {
    const auto coarse = generate(40).value(), middle = generate(80).value(), fine = generate(160).value();
    for (int y = 0; y <= 40; ++y)
        for (int x = 0; x <= 40; ++x) {
            const auto c = static_cast<std::size_t>(y) * 41 + x;
            const auto m = static_cast<std::size_t>(2 * y) * 81 + 2 * x,
                       f = static_cast<std::size_t>(4 * y) * 161 + 4 * x;
            ASSERT_EQ(coarse.surface[c], middle.surface[m]);
            ASSERT_EQ(coarse.surface[c], fine.surface[f]);
            ASSERT_EQ(coarse.cover[c], fine.cover[f]);
        }
}

TEST(Generators, make_the_same_mountain_on_every_grid) {
    expect_one_mountain([](int squares) { return generate_soil_slope({}, squares); });
    expect_one_mountain([](int squares) { return generate_alpine_valley({}, squares); });
}

TEST(Generators, round_to_whole_multiples) {
    for (const auto& terrain : {generate_soil_slope().value(), generate_alpine_valley({}, 40).value()})
        for (const auto* field : {&terrain.surface, &terrain.cover})
            for (const float value : *field) ASSERT_EQ(value * 1024, std::nearbyint(value * 1024));
}

template <class Recipe, class Numbers, class Generate>
void expect_ranges(const Numbers& numbers, Generate generate) {
    for (const auto& number : numbers) {
        const Recipe usual;
        EXPECT_TRUE(usual.*(number.value) >= number.lowest && usual.*(number.value) <= number.highest)
            << number.name;
        for (const double beyond : {number.lowest - 1, number.highest + 1, std::nan("")}) {
            Recipe recipe;
            recipe.*(number.value) = beyond;
            const auto terrain = generate(recipe);
            ASSERT_FALSE(terrain) << number.name;
            EXPECT_NE(terrain.error().find(number.name), std::string::npos) << terrain.error();
        }
        for (const double end : {number.lowest, number.highest}) {
            Recipe recipe;
            recipe.*(number.value) = end;
            const auto terrain = generate(recipe);
            ASSERT_TRUE(terrain) << terrain.error();
            for (const float height : terrain->surface)
                ASSERT_TRUE(std::isfinite(height)) << number.name << " " << end;
        }
    }
}

TEST(Generators, refuse_a_number_out_of_its_range_by_name) {
    expect_ranges<SoilSlope>(kSoilSlopeNumbers,
                             [](const SoilSlope& recipe) { return generate_soil_slope(recipe, 8); });
    expect_ranges<AlpineValley>(kAlpineValleyNumbers,
                                [](const AlpineValley& recipe) { return generate_alpine_valley(recipe, 8); });
    EXPECT_FALSE(generate_soil_slope({}, 7));
    EXPECT_FALSE(generate_alpine_valley({}, 4097));
}

}  // namespace
}  // namespace terrains
