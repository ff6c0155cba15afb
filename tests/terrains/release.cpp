#include "terrains/release.h"
#include <algorithm>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "terrains/export.h"
#include "tests/support/places.h"
#include "tests/terrains/files.h"

namespace terrains {
namespace {

constexpr double kEast = 683'000, kNorth = 5'240'000;

// Level ground of 40 × 30 squares of 10 m in UTM 32N.
Terrain ground(Georeference georeference) {
    Terrain terrain;
    terrain.name = "ground";
    terrain.grid = {41, 31, 10.f};
    terrain.surface.assign(terrain.grid.size(), 1000.f);
    terrain.cover.assign(terrain.grid.size(), 0.f);
    terrain.has_data.assign(terrain.grid.size(), 1);
    terrain.georeference = std::move(georeference);
    return terrain;
}
Terrain utm_ground() {
    return ground(Georeference::projected(test::utm_32n(), kEast, kNorth));
}

double volume(const Terrain& terrain, const std::vector<float>& thickness) {
    return std::accumulate(thickness.begin(), thickness.end(), 0.0) * terrain.grid.cell_area();
}

// A ring in degrees around a box given in the terrain's metres.
std::string ring(const Terrain& terrain, double west, double south, double east, double north) {
    std::string text;
    for (const LocalPoint p :
         {LocalPoint{west, south}, {east, south}, {east, north}, {west, north}, {west, south}}) {
        const auto there = terrain.georeference.to_lat_lon(p).value();
        text +=
            fmt::format("{}[{:.10f}, {:.10f}]", text.empty() ? "" : ", ", there.longitude, there.latitude);
    }
    return "[" + text + "]";
}

std::string feature(const std::string& properties, const std::string& type, const std::string& coordinates) {
    return R"({ "type": "Feature", "properties": {)" + properties + R"(}, "geometry": { "type": ")" + type +
           R"(", "coordinates": )" + coordinates + " } }";
}

std::string collection(const std::string& features, const std::string& more = "") {
    return R"({ "type": "FeatureCollection", )" + more + R"("features": [)" + features + "] }";
}

class Release : public testing::Test {
  protected:
    tl::expected<std::vector<float>, std::string> read(const std::string& text, const Terrain& terrain) {
        test::write_text(path_, text);
        return test::thickness_in(path_, terrain);
    }
    std::string refusal(const std::string& text, const Terrain& terrain) {
        const auto thickness = read(text, terrain);
        std::string said = thickness ? "it was read" : thickness.error();
        EXPECT_NE(said.find("area.geojson: "), std::string::npos) << said;
        return said;
    }

    support::TemporaryFolder folder_;
    std::filesystem::path path_ = folder_.path() / "area.geojson";
};

TEST_F(Release, puts_the_thickness_of_a_polygon_on_its_cells) {
    const Terrain terrain = utm_ground();
    const auto thickness = read(
        collection(feature(R"("thickness": 1.5)", "Polygon", "[" + ring(terrain, 95, 45, 145, 75) + "]")),
        terrain);
    ASSERT_TRUE(thickness) << thickness.error();
    for (int y = 0; y < 31; ++y)
        for (int x = 0; x < 41; ++x)
            ASSERT_EQ((*thickness)[y * 41 + x], x >= 10 && x <= 14 && y >= 5 && y <= 7 ? 1.5f : 0.f)
                << x << ", " << y;
}

TEST_F(Release, conserves_the_volume_for_any_polygon_or_plane) {
    for (const Terrain& terrain : {utm_ground(), ground(Georeference::local({47.3, 11.43}, -200, -150))}) {
        const std::string parts = "[[" + ring(terrain, 33, 41, 171, 98) + ", " +
                                  ring(terrain, 71, 57, 111, 83) + "], [" +
                                  ring(terrain, 207, 141, 333, 260) + "]]";
        const auto thickness = read(collection(feature(R"("thickness": 2)", "MultiPolygon", parts)), terrain);
        ASSERT_TRUE(thickness) << thickness.error();
        const double truth = 2 * (138 * 57 - 40 * 26 + 126 * 119.0);
        EXPECT_NEAR(volume(terrain, *thickness), truth, 0.01 * truth);
    }
}

TEST_F(Release, with_a_key_twice_in_an_object_is_refused_with_the_key) {
    const Terrain terrain = utm_ground();
    const std::string square = "[" + ring(terrain, 95, 45, 145, 75) + "]";
    ASSERT_TRUE(read(collection(feature(R"("thickness": 1.5)", "Polygon", square)), terrain));
    const auto expect_refused = [&](const std::string& text, const std::string& key) {
        const std::string said = refusal(text, terrain);
        EXPECT_NE(said.find("the key '" + key + "' twice"), std::string::npos) << said;
    };
    expect_refused(collection(feature(R"("thickness": 1.5, "thickness": 9)", "Polygon", square)),
                   "thickness");
    expect_refused(collection(feature(R"("thickness": 1.5)", "Polygon", square), R"("type": "Feature", )"),
                   "type");
    expect_refused(collection(feature(R"("a": {"b": 1, "c": [], "b": {}})", "Polygon", square)), "b");
    // The same key in other objects is another one.
    EXPECT_TRUE(
        read(collection(feature(R"("thickness": 1.5, "a": {"thickness": 9})", "Polygon", square)), terrain));
}

TEST_F(Release, accepts_one_feature_and_an_extent_a_bare_geometry_too) {
    const Terrain terrain = utm_ground();
    const std::string coordinates = "[" + ring(terrain, 95, 45, 145, 75) + "]";
    EXPECT_TRUE(read(feature(R"("thickness": 1)", "Polygon", coordinates), terrain));
    test::write_text(path_, R"({ "type": "Polygon", "coordinates": )" + coordinates + " }");
    EXPECT_TRUE(test::extent_in(path_, terrain));
}

TEST_F(Release, requires_one_thickness) {
    const Terrain terrain = utm_ground();
    const std::string area = "[" + ring(terrain, 95, 45, 145, 75) + "]";
    EXPECT_NE(refusal(collection(feature("", "Polygon", area)), terrain)
                  .find("feature 1: it has neither 'thickness'"),
              std::string::npos);
    EXPECT_NE(
        refusal(collection(feature(R"("thickness": 1, "thickness_normal": 1)", "Polygon", area)), terrain)
            .find("feature 1: it has both 'thickness'"),
        std::string::npos);
}

// A plane with slopes of .8 and .6: a layer is √2 times as thick vertically as normal to it.
Terrain tilted(Terrain terrain) {
    for (int y = 0; y < terrain.grid.ny; ++y)
        for (int x = 0; x < terrain.grid.nx; ++x)
            terrain.surface[static_cast<std::size_t>(y * terrain.grid.nx + x)] =
                terrain.grid.dx * (0.8f * static_cast<float>(x) - 0.6f * static_cast<float>(y));
    return terrain;
}

TEST_F(Release, is_thicker_vertically_than_normal_to_the_slope) {
    const Terrain terrain = tilted(utm_ground());
    const std::string area = "[" + ring(terrain, 95, 45, 145, 75) + "]";
    const std::string far = "[" + ring(terrain, 195, 145, 245, 175) + "]";
    const auto both = read(collection(feature(R"("thickness_normal": 1.5)", "Polygon", area) + "," +
                                      feature(R"("thickness": 1)", "Polygon", far)),
                           terrain);
    ASSERT_TRUE(both) << both.error();
    EXPECT_NEAR(volume(terrain, *both), (1.5 * std::sqrt(2.0) + 1) * 50 * 30, 1);

    // The plane reaches the border, where differences are one-sided.
    const auto whole = read(collection(feature(R"("thickness_normal": 1)", "Polygon",
                                               "[" + ring(terrain, -100, -100, 900, 900) + "]")),
                            terrain);
    ASSERT_TRUE(whole) << whole.error();
    for (const float thickness : *whole) EXPECT_NEAR(thickness, std::sqrt(2.0), 1e-3);
}

TEST_F(Release, is_measured_as_one_says) {
    const Terrain terrain = tilted(utm_ground());
    const auto path = test::write_ascii_grid(folder_.path(), "depth",
                                             {.columns = 12,
                                              .rows = 9,
                                              .west = kEast + 113,
                                              .south = kNorth + 92,
                                              .cell = 7,
                                              .prj = test::utm_32n()},
                                             [](double, double) { return 3.0; });
    const auto vertical = test::thickness_in(path, terrain),
               same = test::thickness_in(path, terrain, Thickness::kVertical),
               normal = test::thickness_in(path, terrain, Thickness::kNormal);
    ASSERT_TRUE(vertical && same && normal);
    EXPECT_EQ(*vertical, *same);
    EXPECT_NEAR(volume(terrain, *normal), std::sqrt(2.0) * volume(terrain, *vertical), 1);

    test::write_text(path_, collection(feature(R"("thickness": 1)", "Polygon",
                                               "[" + ring(terrain, 95, 45, 145, 75) + "]")));
    const auto upright = test::thickness_in(path_, terrain, Thickness::kVertical),
               tilted_areas = test::thickness_in(path_, terrain, Thickness::kNormal);
    ASSERT_TRUE(upright && tilted_areas);
    EXPECT_NEAR(volume(terrain, *upright), 50 * 30, 0.1);
    EXPECT_NEAR(volume(terrain, *tilted_areas), std::sqrt(2.0) * 50 * 30, 0.1);
    // A name that says the contrary.
    test::write_text(path_, collection(feature(R"("thickness_normal": 1)", "Polygon",
                                               "[" + ring(terrain, 95, 45, 145, 75) + "]")));
    EXPECT_TRUE(test::thickness_in(path_, terrain, Thickness::kNormal));
    const auto contrary = test::thickness_in(path_, terrain, Thickness::kVertical);
    ASSERT_FALSE(contrary);
    EXPECT_NE(contrary.error().find("leave --thickness out"), std::string::npos) << contrary.error();
}

TEST_F(Release, names_byte_or_feature_of_damage) {
    const Terrain terrain = utm_ground();
    const std::string good =
        feature(R"("thickness": 1)", "Polygon", "[" + ring(terrain, 95, 45, 145, 75) + "]");
    const auto says = [&](const std::string& text, const std::string& fact) {
        const std::string said = refusal(text, terrain);
        EXPECT_NE(said.find(fact), std::string::npos) << said;
    };
    const std::string whole = collection(good);
    for (std::size_t length = 1; length < whole.size(); length += 5)
        EXPECT_NE(refusal(whole.substr(0, length), terrain).find("byte "), std::string::npos) << length;
    says(R"({ "type": tru })", "byte ");
    says("{}", "thickness");
    says(collection(""), "no features");
    says(collection(good + "," + feature(R"("thickness": 1)", "Point", "[11, 47]")),
         "feature 2: its geometry is 'Point'");
    says(collection(feature(R"("thickness": "1 m")", "Polygon", "[]")),
         "feature 1: its 'thickness' is not a number");
    says(collection(feature(R"("thickness": -1)", "Polygon", "[]")), "'thickness' is -1 m");
    says(collection(feature(R"("thickness": 1)", "Polygon", "[]")), "feature 1: a polygon has no rings");
    says(collection(feature(R"("thickness": 1)", "Polygon", "[[[11, 47], [11, 48]]]")),
         "fewer than 4 points");
    says(collection(feature(R"("thickness": 1)", "Polygon", "[[[11, 47], [11], [12, 47], [11, 47]]]")),
         "not two numbers");
    says(collection(feature(R"("thickness": 1)", "Polygon", "[[[683000, 5240000], [0, 0], [0, 1], [1, 1]]]")),
         "683000, 5240000 is not a longitude and latitude");
    says(collection(good, R"("crs": { "type": "name", "properties": { "name": "EPSG:32632" } }, )"),
         "coordinate system is EPSG:32632");
    says(R"({ "a": )" + std::string(100'000, '[') + std::string(100'000, ']') + "}", "nested deeper");
}

TEST_F(Release, refuses_polygons_that_touch_no_ground) {
    Terrain terrain = utm_ground();
    const std::string away =
        collection(feature(R"("thickness": 1)", "Polygon", "[" + ring(terrain, 900, 900, 950, 950) + "]"));
    EXPECT_NE(refusal(away, terrain).find("ground of ground"), std::string::npos);
    const std::string here =
        collection(feature(R"("thickness": 1)", "Polygon", "[" + ring(terrain, 95, 45, 145, 75) + "]"));
    terrain.has_data.assign(terrain.has_data.size(), 0);
    EXPECT_NE(refusal(here, terrain).find("ground of ground"), std::string::npos);
}

TEST_F(Release, refuses_degrees_for_a_terrain_that_is_not_placed) {
    const std::string text =
        collection(feature(R"("thickness": 1)", "Polygon", "[" + ring(utm_ground(), 0, 0, 9, 9) + "]"));
    EXPECT_NE(refusal(text, ground({})).find("coordinate system"), std::string::npos);
    EXPECT_FALSE(test::thickness_in(folder_.path() / "none.geojson", utm_ground()));
}

TEST_F(Release, resamples_a_depth_raster_by_coordinates_and_conserves_its_volume) {
    // 3 m in pixels of 7 m from (113, 92) to (113 + 84, 92 + 63): no pixel coincides with the terrain's
    // cells.
    for (const double cell : {7.0, 21.0, 3.5}) {
        test::AsciiGrid grid{.columns = static_cast<int>(84 / cell),
                             .rows = static_cast<int>(63 / cell),
                             .west = kEast + 113 + cell / 2,
                             .south = kNorth + 92 + cell / 2,
                             .cell = cell,
                             .prj = test::utm_32n()};
        const auto path =
            test::write_ascii_grid(folder_.path(), "depth", grid, [](double, double) { return 3.0; });
        const Terrain terrain = utm_ground();
        const auto thickness = test::thickness_in(path, terrain);
        ASSERT_TRUE(thickness) << thickness.error();
        EXPECT_NEAR(volume(terrain, *thickness), 3 * 84 * 63, 0.01 * 3 * 84 * 63);
        EXPECT_FLOAT_EQ((*thickness)[12 * 41 + 15], 3);
        EXPECT_EQ((*thickness)[12 * 41 + 8], 0);
    }
}

TEST_F(Release, resamples_a_depth_raster_between_systems) {
    test::AsciiGrid grid{.columns = 40,
                         .rows = 40,
                         .west = 11.4205,
                         .south = 47.2885,
                         .cell = 0.00005,
                         .prj = test::degrees()};
    const auto path =
        test::write_ascii_grid(folder_.path(), "depth", grid, [](double, double) { return 2.0; });
    const Terrain terrain = ground(Georeference::projected(test::utm_32n(), 682'950, 5'240'050));
    const auto thickness = test::thickness_in(path, terrain);
    ASSERT_TRUE(thickness) << thickness.error();
    const double area = 0.002 * 0.002 * 111'176 * 75'595;  // m per degree at 47.29° N
    EXPECT_NEAR(volume(terrain, *thickness), 2 * area, 0.01 * 2 * area);
}

TEST_F(Release, reads_negative_depths_as_amounts_and_refuses_both_signs) {
    const Terrain terrain = ground(Georeference::unnamed(1000, 2000));
    const auto write = [&](const test::Height& depth) {
        return test::write_ascii_grid(folder_.path(), "depth",
                                      {.columns = 10, .rows = 10, .west = 1100, .south = 2100}, depth);
    };
    const auto positive =
        test::thickness_in(write([](double x, double) { return x > 1150 ? 1.25 : 0; }), terrain);
    ASSERT_TRUE(positive) << positive.error();
    EXPECT_EQ(test::thickness_in(write([](double x, double) { return x > 1150 ? -1.25 : 0; }), terrain),
              positive);
    const auto both =
        test::thickness_in(write([](double x, double) { return x > 1150 ? -1.25 : 1; }), terrain);
    ASSERT_FALSE(both);
    EXPECT_NE(both.error().find("both signs"), std::string::npos) << both.error();
    const auto deep = test::thickness_in(write([](double, double) { return 201.0; }), terrain);
    ASSERT_FALSE(deep);
    EXPECT_NE(deep.error().find("row 1, column 1 is 201 m deep"), std::string::npos) << deep.error();
}

TEST_F(Release, refuses_depth_rasters_that_cannot_be_aligned_with_the_terrain) {
    const auto flat = [](double, double) { return 1.0; };
    const auto bare = test::write_ascii_grid(folder_.path(), "bare", {.west = 10, .south = 10}, flat);
    const auto named = test::write_ascii_grid(folder_.path(), "named",
                                              {.west = kEast, .south = kNorth, .prj = test::utm_32n()}, flat);
    EXPECT_FALSE(test::thickness_in(bare, ground({})));
    EXPECT_FALSE(test::thickness_in(bare, ground(Georeference::local({47.3, 11.4}, 0, 0))));
    EXPECT_FALSE(test::thickness_in(named, ground(Georeference::unnamed(kEast, kNorth))));
    EXPECT_FALSE(test::thickness_in(bare, utm_ground()));  // far away
    EXPECT_TRUE(test::thickness_in(named, utm_ground()));
    EXPECT_FALSE(test::thickness_in(folder_.path() / "none.tif", utm_ground()));
}

TEST_F(Release, leaves_no_data_bare) {
    Terrain terrain = utm_ground();
    terrain.has_data[6 * 41 + 12] = 0;
    const auto thickness =
        read(collection(feature(R"("thickness": 1)", "Polygon", "[" + ring(terrain, 95, 45, 145, 75) + "]")),
             terrain);
    ASSERT_TRUE(thickness) << thickness.error();
    EXPECT_EQ((*thickness)[6 * 41 + 12], 0);
    EXPECT_EQ((*thickness)[6 * 41 + 13], 1);
}

TEST_F(Release, reads_an_extent_whether_or_not_it_has_a_thickness) {
    const Terrain terrain = utm_ground();
    for (const char* properties : {"", R"("thickness": 0.001)", R"("thickness": "thick")"}) {
        test::write_text(path_, collection(feature(properties, "Polygon",
                                                   fmt::format("[{}]", ring(terrain, 95, 45, 149, 75)))));
        const auto extent = test::extent_in(path_, terrain);
        ASSERT_TRUE(extent) << extent.error();
        EXPECT_EQ(std::accumulate(extent->begin(), extent->end(), 0), 15)
            << properties;  // 0.4 of a cell is outside
    }
    test::write_text(path_, collection(feature("", "Polygon", "[" + ring(terrain, 950, 45, 990, 75) + "]")));
    EXPECT_FALSE(test::extent_in(path_, terrain));
}

TEST_F(Release, reads_a_reference_as_an_extent_or_as_a_change_with_its_signs) {
    const Terrain terrain = ground(Georeference::unnamed(1000, 2000));
    const auto write = [&](const test::Height& change) {
        return test::write_ascii_grid(folder_.path(), "change",
                                      {.columns = 10, .rows = 10, .west = 1100, .south = 2100}, change);
    };
    const auto change =
        read_reference(write([](double x, double) { return x > 1150 ? -1.25 : 0.5; }), terrain);
    ASSERT_TRUE(change) << change.error();
    EXPECT_TRUE(change->extent.empty());
    const auto [lowest, highest] = std::minmax_element(change->change.begin(), change->change.end());
    EXPECT_EQ(*lowest, -1.25f);
    EXPECT_EQ(*highest, 0.5f);
    const auto none = read_reference(write([](double, double) { return 0.0; }), terrain);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().find("change on"), std::string::npos) << none.error();

    test::write_text(path_,
                     collection(feature("", "Polygon", "[" + ring(utm_ground(), 95, 45, 149, 75) + "]")));
    const auto extent = read_reference(path_, utm_ground());
    ASSERT_TRUE(extent) << extent.error();
    EXPECT_TRUE(extent->change.empty());
    EXPECT_FALSE(extent->extent.empty());
}

// Where the volume of a release goes.
TEST_F(Release, tells_the_volume_of_its_polygons_and_each_loss_with_its_cause) {
    const auto of = [&](const Terrain& terrain, const std::string& features) {
        test::write_text(path_, collection(features));
        return read_release(path_, terrain).value();
    };
    const auto square = [](const Terrain& terrain, double west, double south, double east, double north,
                           double thick) {
        return feature(fmt::format(R"("thickness": {})", thick), "Polygon",
                       fmt::format("[{}]", ring(terrain, west, south, east, north)));
    };
    Terrain terrain = utm_ground();  // cells from -5 to 405 and -5 to 305
    const auto whole = of(terrain, square(terrain, 95, 45, 145, 75, 2));
    EXPECT_NEAR(whole.volumes.in_file, 3000, 0.1);
    EXPECT_NEAR(whole.volumes.on_ground, 3000, 0.1);
    EXPECT_NEAR(whole.volumes.lost(), 0, 0.1);
    EXPECT_FALSE(whole.volumes.much_is_lost());
    EXPECT_TRUE(whole.vertical && !whole.normal);

    const auto beyond = of(terrain, square(terrain, -55, 45, 45, 75, 2));
    EXPECT_NEAR(beyond.volumes.in_file, 6000, 0.1);
    EXPECT_NEAR(beyond.volumes.on_ground, 3000, 0.1);
    EXPECT_NEAR(beyond.volumes.outside, 3000, 0.1);
    EXPECT_TRUE(beyond.volumes.much_is_lost());

    const auto twice =
        of(terrain, square(terrain, 95, 45, 145, 75, 2) + "," + square(terrain, 125, 45, 175, 75, 1));
    EXPECT_NEAR(twice.volumes.in_file, 4500, 0.1);
    EXPECT_NEAR(twice.volumes.overlap, 600, 0.1);
    EXPECT_NEAR(twice.volumes.on_ground, 3900, 0.1);

    terrain.has_data[6 * 41 + 12] = 0;
    const auto hole = of(terrain, square(terrain, 95, 45, 145, 75, 2));
    EXPECT_NEAR(hole.volumes.on_no_data, 200, 0.1);
    EXPECT_NEAR(hole.volumes.on_ground, 2800, 0.1);

    // Normal to the slope, beyond the grid as within it.
    const Terrain slope = tilted(utm_ground());
    const auto normal =
        of(slope, feature(R"("thickness_normal": 2)", "Polygon", "[" + ring(slope, -55, 45, 45, 75) + "]"));
    EXPECT_NEAR(normal.volumes.in_file, 6000 * std::sqrt(2.0), 1);
    EXPECT_NEAR(normal.volumes.outside, 3000 * std::sqrt(2.0), 1);
    EXPECT_TRUE(normal.normal && !normal.vertical);
}

TEST_F(Release, tells_what_of_a_raster_lies_outside) {
    const Terrain terrain = utm_ground();
    for (const double cell : {7.0, 21.0})
        for (const double east : {113.0, -42.0, 363.0}) {
            const auto path = test::write_ascii_grid(folder_.path(), "depth",
                                                     {.columns = static_cast<int>(84 / cell),
                                                      .rows = static_cast<int>(63 / cell),
                                                      .west = kEast + east + cell / 2,
                                                      .south = kNorth + 92 + cell / 2,
                                                      .cell = cell,
                                                      .prj = test::utm_32n()},
                                                     [](double, double) { return 3.0; });
            const auto release = read_release(path, terrain);
            ASSERT_TRUE(release) << release.error();
            const double in_file = 3 * 84 * 63, inside = east < 0 ? 47 : east > 300 ? 42 : 84;
            EXPECT_NEAR(release->volumes.in_file, in_file, 1e-3 * in_file);
            EXPECT_NEAR(release->volumes.on_ground, in_file * inside / 84, 0.02 * in_file);
            EXPECT_NEAR(release->volumes.outside, in_file * (1 - inside / 84), 0.02 * in_file);
            EXPECT_EQ(release->volumes.much_is_lost(), inside < 84) << cell << " " << east;
        }
}

TEST_F(Release, tells_the_volume_of_a_raster_in_another_system) {
    const auto path = test::write_ascii_grid(folder_.path(), "depth",
                                             {.columns = 40,
                                              .rows = 40,
                                              .west = 11.4205,
                                              .south = 47.2885,
                                              .cell = 0.00005,
                                              .prj = test::degrees()},
                                             [](double, double) { return 2.0; });
    const auto release =
        read_release(path, ground(Georeference::projected(test::utm_32n(), 682'950, 5'240'050)));
    ASSERT_TRUE(release) << release.error();
    const double truth = 2 * 0.002 * 0.002 * 111'176 * 75'595;
    EXPECT_NEAR(release->volumes.in_file, truth, 0.005 * truth);
    EXPECT_FALSE(release->volumes.much_is_lost());
}

TEST_F(Release, skips_and_counts_features_whose_geometry_is_null) {
    const Terrain terrain = utm_ground();
    const std::string null = R"({ "type": "Feature", "properties": {}, "geometry": null })";
    const std::string area =
        feature(R"("thickness": 1)", "Polygon", "[" + ring(terrain, 95, 45, 145, 75) + "]");
    test::write_text(path_, collection(null + "," + area + "," + null));
    const auto release = read_release(path_, terrain);
    ASSERT_TRUE(release) << release.error();
    EXPECT_EQ(release->without_geometry, 2u);
    EXPECT_NEAR(release->volumes.on_ground, 1500, 0.1);
    const auto reference = read_reference(path_, terrain);
    ASSERT_TRUE(reference) << reference.error();
    EXPECT_EQ(reference->without_geometry, 2u);
    EXPECT_NE(refusal(collection(null), terrain).find("none of its features has a geometry"),
              std::string::npos);
    EXPECT_NE(refusal(null, terrain).find("no geometry"), std::string::npos);
    EXPECT_NE(refusal(collection(R"({ "type": "Feature", "properties": { "thickness": 1 } })"), terrain)
                  .find("feature 1: it has no geometry"),
              std::string::npos);
}

TEST_F(Release, of_another_format_gets_the_command_that_makes_geojson_of_it) {
    using namespace std::string_literals;
    const Terrain terrain = utm_ground();
    for (const auto& [name, beginning] :
         {std::pair{"a.shp", "\0\0\x27\x0a"s}, std::pair{"a.dbf", "\x03"s},
          std::pair{"a.gpkg", "SQLite format 3\0"s}, std::pair{"a.kml", "<?xml version=\"1.0\"?>\n<kml>"s},
          std::pair{"a.fgb", "fgb\x03"s}, std::pair{"a.gml", "<x xmlns:gml=\"http://www.opengis.net/gml\">"s},
          std::pair{"a.zip", "PK\x03\x04"s}}) {
        const auto path = folder_.path() / name;
        test::write_text(path, beginning + std::string(300, '\0'));
        for (const auto& error :
             {read_release(path, terrain).error(), read_reference(path, terrain).error()}) {
            EXPECT_NE(error.find("ogr2ogr -f GeoJSON -t_srs EPSG:4326"), std::string::npos) << error;
            EXPECT_NE(error.find("a.geojson"), std::string::npos) << error;
        }
    }
    test::write_text(folder_.path() / "a.txt", "nothing");
    EXPECT_EQ(read_release(folder_.path() / "a.txt", terrain).error().find("ogr2ogr"), std::string::npos);
}

}  // namespace
}  // namespace terrains
