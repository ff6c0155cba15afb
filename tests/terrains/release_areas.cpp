#include "terrains/release_areas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <vector>

#include "terrains/dem_gdal.h"
#include "terrains/export.h"
#include "terrains/release.h"
#include "tests/support/places.h"
#include "tests/terrains/files.h"

namespace terrains {
namespace {

const sim::Grid kGrid{81, 61, 10};
constexpr double kRadians = std::numbers::pi / 180;

// Heights of a function of metres from the grid's south-west vertex.
std::vector<float> ground(const std::function<double(double x, double y)>& height) {
    std::vector<float> surface;
    for (int y = 0; y < kGrid.ny; ++y)
        for (int x = 0; x < kGrid.nx; ++x) surface.push_back(static_cast<float>(height(10 * x, 10 * y)));
    return surface;
}
std::vector<float> plane(double slope_deg, double aspect_deg) {
    const double rise = std::tan(slope_deg * kRadians);
    return ground([&](double x, double y) {
        return 2000 - rise * (std::sin(aspect_deg * kRadians) * x + std::cos(aspect_deg * kRadians) * y);
    });
}
// Rules without an upper bound of the size.
ReleaseRules uncut() {
    ReleaseRules rules;
    rules.most_area = 1e9;
    return rules;
}

ReleaseAreas found_on(const std::vector<float>& surface, const ReleaseRules& rules = uncut(),
                      const std::vector<std::uint8_t>& forest = {},
                      const std::vector<std::uint8_t>& known = {}) {
    return find_release_areas(kGrid, surface, known, forest, rules);
}
int at(const ReleaseAreas& found, int x, int y) {
    return found.number[static_cast<std::size_t>(y * kGrid.nx + x)];
}

TEST(ReleaseAreas, are_the_whole_of_a_plane_that_is_steep_enough) {
    for (const double aspect : {0.0, 45.0, 90.0, 200.0, 315.0}) {
        const ReleaseAreas found = found_on(plane(35, aspect));
        ASSERT_EQ(found.areas.size(), 1u) << aspect;
        const ReleaseArea& area = found.areas.front();
        // Of the outermost cells the shape is not known; next to them most of nine are.
        EXPECT_NEAR(area.area, 79 * 59 * 100, 4 * 100) << aspect;
        EXPECT_NEAR(area.area_on_slope, area.area / std::cos(35 * kRadians), 1e-3 * area.area);
        EXPECT_NEAR(area.slope, 35, 0.01);
        EXPECT_NEAR(std::remainder(area.aspect - aspect, 360), 0, 0.01);
        EXPECT_NEAR(area.middle.x, 400, 1);
        EXPECT_NEAR(area.middle.y, 300, 1);
        EXPECT_GT(area.favour, 0.6);
    }
}

TEST(ReleaseAreas, are_nowhere_too_flat_or_too_steep) {
    for (const double slope : {10.0, 27.5, 55.5, 70.0})
        EXPECT_TRUE(found_on(plane(slope, 180)).areas.empty()) << slope;
    for (const double slope : {28.5, 54.5}) EXPECT_EQ(found_on(plane(slope, 180)).areas.size(), 1u) << slope;
    ReleaseRules rules = uncut();
    rules.least_slope = 20;
    EXPECT_EQ(found_on(plane(22, 180), rules).areas.size(), 1u);
}

TEST(ReleaseAreas, are_parted_by_ribs_and_gullies) {
    for (const double sign : {1.0, -1.0}) {
        // A roof, or a valley, that runs south and falls by 38° to either side.
        const ReleaseAreas found = found_on(ground(
            [&](double x, double) { return 2000 - sign * std::tan(38 * kRadians) * std::fabs(x - 400); }));
        ASSERT_EQ(found.areas.size(), 2u) << sign;
        std::set<int> west, east;
        for (int y = 2; y < kGrid.ny - 2; ++y) west.insert(at(found, 10, y)), east.insert(at(found, 70, y));
        EXPECT_EQ(west.size(), 1u);
        EXPECT_EQ(east.size(), 1u);
        EXPECT_NE(*west.begin(), *east.begin());
        EXPECT_EQ(at(found, 40, 30), 0) << "the rib itself";
        EXPECT_NEAR(found.areas[0].area, found.areas[1].area, 0.05 * found.areas[0].area);
    }
}

TEST(ReleaseAreas, are_parted_where_a_cone_turns) {
    // Falls by 35° to all sides: eight slopes.
    const ReleaseAreas found = found_on(ground(
        [](double x, double y) { return 2000 - std::tan(35 * kRadians) * std::hypot(x - 400, y - 300); }));
    EXPECT_EQ(found.areas.size(), 8u);
    std::set<long> aspects;
    for (const ReleaseArea& area : found.areas) aspects.insert(std::lround(area.aspect / 45) % 8);
    EXPECT_EQ(aspects.size(), 8u);
}

TEST(ReleaseAreas, are_cut_where_a_face_has_a_rib_and_else_in_the_middle) {
    ReleaseRules rules;
    rules.most_area = 300'000;
    const ReleaseAreas even = found_on(plane(35, 180), rules);
    ASSERT_EQ(even.areas.size(), 2u);
    EXPECT_NEAR(even.areas[0].area, even.areas[1].area, 2 * 59 * 100);
    EXPECT_NE(at(even, 38, 30), at(even, 42, 30));
    // A broad rib of 8 m, far from the middle.
    rules.most_area = 400'000;
    const ReleaseAreas ribbed =
        found_on(ground([](double x, double y) {
                     return 2000 + std::tan(35 * kRadians) * y + 8 * std::exp(-std::pow((x - 550) / 80, 2));
                 }),
                 rules);
    ASSERT_EQ(ribbed.areas.size(), 2u);
    EXPECT_EQ(at(ribbed, 38, 30), at(ribbed, 52, 30));
    EXPECT_NE(at(ribbed, 52, 30), at(ribbed, 58, 30));
    rules.most_area = 20'000;
    const ReleaseAreas small = found_on(plane(35, 200), rules);
    EXPECT_GE(small.areas.size(), 79u * 59u * 100u / 20'000u);
    for (const ReleaseArea& area : small.areas) {
        EXPECT_GT(area.area, 2500);
        EXPECT_LT(area.area, 24'000);
    }
}

TEST(ReleaseAreas, are_not_where_the_ground_is_rough_wooded_or_unknown) {
    const std::vector<float> smooth = plane(35, 180);
    std::vector<float> rough = smooth;
    std::vector<std::uint8_t> forest(kGrid.size()), known(kGrid.size(), 1);
    for (int y = 0; y < kGrid.ny; ++y)
        for (int x = 0; x < 40; ++x) {
            const auto i = static_cast<std::size_t>(y * kGrid.nx + x);
            rough[i] += 1.5f * static_cast<float>((7919 * x + 104729 * y * y) % 11);
            forest[i] = 200, known[i] = 0;
        }
    for (const ReleaseAreas& found :
         {found_on(rough), found_on(smooth, uncut(), forest), found_on(smooth, uncut(), {}, known)}) {
        ASSERT_EQ(found.areas.size(), 1u);
        EXPECT_EQ(at(found, 20, 30), 0);
        EXPECT_EQ(at(found, 60, 30), 1);
        EXPECT_NEAR(found.areas[0].area, 40 * 59 * 100, 3 * 59 * 100);
    }
}

TEST(ReleaseAreas, join_small_pieces_to_a_neighbour_and_leave_out_what_has_none) {
    // A slope to the south with a dent of a few cells that turns to the south-west, and one far patch of 8 by 8 cells.
    const auto surface = ground([](double x, double y) {
        const double slope = 2000 - std::tan(35 * kRadians) * y;
        if (x > 500 && y < 300) return x > 700 && x < 780 && y > 100 && y < 180 ? slope : 1500.0;
        return slope;
    });
    ReleaseRules rules = uncut();
    rules.least_area = 10'000;
    const ReleaseAreas few = found_on(surface, rules);
    rules.least_area = 100;
    const ReleaseAreas many = found_on(surface, rules);
    EXPECT_EQ(few.areas.size(), 1u);
    EXPECT_GT(many.areas.size(), few.areas.size());
    EXPECT_GE(few.areas.back().area, 10'000);
    for (std::size_t i = 1; i < many.areas.size(); ++i)
        EXPECT_GE(many.areas[i - 1].area, many.areas[i].area) << "the largest first";
}

TEST(ReleaseAreas, are_the_release_of_a_run_once_they_are_written) {
    support::TemporaryFolder folder;
    Terrain terrain{
        "roof",
        "",
        kGrid,
        ground([](double x, double) { return 2000 - std::tan(38 * kRadians) * std::fabs(x - 400); }),
        std::vector<float>(kGrid.size()),
        std::vector<std::uint8_t>(kGrid.size(), 1),
        Georeference::projected(test::utm_32n(), 683'000, 5'240'000)};
    const ReleaseAreas found = found_on(terrain.surface);
    std::vector<Properties> properties;
    double volume = 0;
    for (const ReleaseArea& area : found.areas) {
        properties.push_back({{"thickness_normal", 0.8}, {"slope_deg", area.slope}});
        volume += 0.8 * area.area_on_slope;
    }
    const auto file = folder.path() / "areas.geojson";
    ASSERT_TRUE(write_areas(file, kGrid, terrain.georeference, found.number, properties));
    const auto release = read_release(file, terrain);
    ASSERT_TRUE(release) << release.error();
    EXPECT_NEAR(release->volumes.in_file, volume, 0.01 * volume);
    for (std::size_t i = 0; i < release->thickness.size(); ++i)
        EXPECT_EQ(release->thickness[i] > 0.5f, found.number[i] > 0) << i;
}

}  // namespace
}  // namespace terrains
