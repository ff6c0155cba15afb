#include "terrains/locator.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "terrains/dem_gdal.h"
#include "tests/support/allocations.h"
#include "tests/support/places.h"
#include "tests/terrains/files.h"

namespace terrains {
namespace {

std::string said(const Locator& locator, LocalPoint p) {
    std::array<char, 96> text;
    text.fill('x');
    locator.describe(p, text);
    return text.data();
}

std::vector<Georeference> placed() {
    return {Georeference::projected(test::utm_32n(), 683'000, 5'240'000),
            Georeference::local({47.3, 11.43}, -900, -2000), Georeference::local({-43.6, -170.14}, 0, 0),
            Georeference::local({89, 0}, 0, 0)};
}

std::int64_t allocations_of(const Georeference& georeference) {
    const Locator locator(georeference);
    std::array<char, 96> text;
    for (int i = 0; i < 10; ++i) locator.describe({1.0 * i, 2.0 * i}, text);
    const std::int64_t before = support::allocations();
    for (int i = 0; i < 100; ++i) locator.describe({3.0 * i, 5.0 * i}, text);
    return support::allocations() - before;
}

TEST(Locator, locates_a_known_place) {
    EXPECT_EQ(said(Locator(Georeference::local({47.30012, 11.4321}, 0, 0)), {0, 0}),
              "47.30012° N 11.43210° E, UTM 32T 683860 5241385");
    EXPECT_EQ(said(Locator(Georeference::projected(test::utm_32n(), 682'000, 5'243'000)), {608, 710}),
              "47.32137° N 11.41651° E, UTM 32T 682608 5243710");
}

TEST(Locator, equals_the_georeference) {
    for (const Georeference& georeference : placed()) {
        const Locator locator(georeference);
        for (const LocalPoint p :
             {LocalPoint{0, 0}, LocalPoint{1234.5, 678.9}, LocalPoint{-20'000, 35'000}}) {
            ASSERT_FALSE(georeference.describe(p).empty());
            EXPECT_EQ(said(locator, p), georeference.describe(p));
        }
    }
}

TEST(Locator, is_empty_if_the_position_is_unknown) {
    for (const Georeference& nowhere :
         {Georeference(), Georeference::unnamed(361'015, 70'223), Georeference::projected("no system", 0, 0)})
        EXPECT_EQ(said(Locator(nowhere), {0, 0}), "");
    EXPECT_EQ(said(Locator(placed()[0]), {1e12, 0}), "");
    EXPECT_EQ(said(Locator(placed()[1]), {std::numeric_limits<double>::quiet_NaN(), 0}), "");
}

TEST(Locator, truncates_to_the_buffer_and_null_terminates) {
    const Locator locator(placed()[1]);
    std::array<char, 9> text;
    text.fill('x');
    locator.describe({900, 2000}, std::span(text).first(6));
    EXPECT_STREQ(text.data(), "47.30");
    EXPECT_EQ(text[6], 'x');
    locator.describe({900, 2000}, {});
}

TEST(Locator, allocates_nothing_for_a_place) {
    const std::int64_t before = support::allocations();
    const Locator prepared(placed()[0]);
    ASSERT_GT(support::allocations() - before, 10) << "the libraries' calls are not counted";
    for (const Georeference& georeference : placed())
        EXPECT_EQ(allocations_of(georeference), 0) << georeference.wkt();
}

TEST(Locator, agrees_with_the_georeference_of_a_real_mountain) {
    if (!support::dem_dir()) GTEST_SKIP() << "COULOIR_DEM_DIR is not set";
    for (const char* name : {"alr/alr.asc", "alr/alr_utm32n.tif", "alr/alr_wgs84.tif"}) {
        const Terrain terrain = read_dem(*support::dem_dir() / name, 40).value();
        const Locator locator(terrain.georeference);
        for (int y = 0; y < terrain.grid.ny; y += 7)
            for (int x = 0; x < terrain.grid.nx; x += 7) {
                const double cell = terrain.grid.dx;
                const std::string text = said(locator, {x * cell, y * cell});
                EXPECT_EQ(text, terrain.georeference.describe({x * cell, y * cell}));
                EXPECT_EQ(text.substr(0, 3), "47.");
            }
        EXPECT_EQ(allocations_of(terrain.georeference), 0) << name;
    }
}

}  // namespace
}  // namespace terrains
