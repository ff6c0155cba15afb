#include "terrains/export.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

#include "terrains/dem_gdal.h"
#include "terrains/release.h"
#include "tests/support/places.h"
#include "tests/terrains/files.h"

namespace terrains {
namespace {

const sim::Grid kGrid{33, 25, 12.5f};

std::vector<float> bumps() {
    std::vector<float> field(kGrid.size());
    for (std::size_t i = 0; i < field.size(); ++i)
        field[i] = 1000 + 7.3f * std::sin(0.1f * static_cast<float>(i * i));
    return field;
}

std::vector<Georeference> places() {
    return {Georeference::projected(test::utm_32n(), 683'012.345, 5'240'067.89),
            Georeference::local({47.3, 11.43}, -200.5, -150.25), Georeference::unnamed(361'020.5, 70'228.25)};
}

void expect_back(const std::filesystem::path& path, const Georeference& place,
                 const std::vector<float>& field) {
    const auto back = read_dem(path, kGrid.nx - 1);
    ASSERT_TRUE(back) << back.error();
    EXPECT_EQ(back->grid, kGrid);
    for (std::size_t i = 0; i < field.size(); ++i) {
        ASSERT_EQ(back->has_data[i], std::isnan(field[i]) ? 0 : 1);
        if (!std::isnan(field[i])) {
            ASSERT_EQ(back->surface[i], field[i]) << "to the last bit";
        }
    }
    EXPECT_EQ(back->georeference.placed(), place.placed());
    EXPECT_NEAR(back->georeference.origin_x(), place.origin_x(), 1e-6);
    EXPECT_NEAR(back->georeference.origin_y(), place.origin_y(), 1e-6);
    if (!place.placed()) return;
    const auto before = place.to_lat_lon({100, 50}).value(),
               after = back->georeference.to_lat_lon({100, 50}).value();
    EXPECT_NEAR(before.latitude, after.latitude, 1e-9);
    EXPECT_NEAR(before.longitude, after.longitude, 1e-9);
}

TEST(Export, is_bit_identical_after_geotiff_and_ascii_round_trips) {
    const support::TemporaryFolder folder;
    std::vector<float> field = bumps();
    field[5 * 33 + 7] = std::nanf("");
    for (const Georeference& place : places()) {
        ASSERT_TRUE(write_geotiff(folder.path() / "field.tif", kGrid, place, field));
        expect_back(folder.path() / "field.tif", place, field);
        ASSERT_TRUE(write_ascii(folder.path() / "field.asc", kGrid, place, field));
        expect_back(folder.path() / "field.asc", place, field);
    }
}

TEST(Export, leaves_no_prj_of_an_earlier_place_behind) {
    const support::TemporaryFolder folder;
    ASSERT_TRUE(write_ascii(folder.path() / "field.asc", kGrid, places()[0], bumps()));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "field.prj"));
    ASSERT_TRUE(write_ascii(folder.path() / "field.asc", kGrid, {}, bumps()));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "field.prj"));
}

TEST(Export, restores_a_mask_from_its_outlines) {
    const support::TemporaryFolder folder;
    std::vector<std::uint8_t> mask(kGrid.size());
    for (int y = 0; y < kGrid.ny; ++y)
        for (int x = 0; x < kGrid.nx; ++x) {
            const double r = std::hypot(x - 12, y - 12);
            mask[static_cast<std::size_t>(y) * kGrid.nx + x] =
                (r < 9 && r > 4) || (x > 26 && (x + y) % 2 == 0) || (x == 12 && y == 12) || (x < 2 && y < 2)
                    ? 1
                    : 0;
        }
    for (const Georeference& place : {places()[0], places()[1]}) {
        Terrain terrain{.name = "t",
                        .licence = {},
                        .grid = kGrid,
                        .surface = bumps(),
                        .cover = bumps(),
                        .has_data = std::vector<std::uint8_t>(kGrid.size(), 1),
                        .georeference = place};
        const auto written = write_outlines(folder.path() / "mask.geojson", kGrid, place, mask);
        ASSERT_TRUE(written) << written.error();
        const auto back = test::extent_in(folder.path() / "mask.geojson", terrain);
        ASSERT_TRUE(back) << back.error();
        EXPECT_EQ(*back, mask);
    }
}

TEST(Export, draws_one_polygon_per_patch_with_its_hole_and_area) {
    const support::TemporaryFolder folder;
    const sim::Grid grid{8, 8, 10.f};
    std::vector<std::uint8_t> mask(grid.size());
    // A frame of 5 × 5 cells open in one corner only, so that its hole touches the outside in a point.
    for (int y = 1; y <= 5; ++y)
        for (int x = 1; x <= 5; ++x) mask[y * 8 + x] = x == 1 || x == 5 || y == 1 || y == 5 ? 1 : 0;
    mask[5 * 8 + 5] = 0;
    mask[7 * 8 + 7] = 1;
    ASSERT_TRUE(write_outlines(folder.path() / "mask.geojson", grid, Georeference::unnamed(100, 200), mask));
    const auto json = nlohmann::json::parse(test::read_text(folder.path() / "mask.geojson"));
    EXPECT_EQ(json["coordinates"], "local metres");
    ASSERT_EQ(json["features"].size(), 2u);
    const auto& frame = json["features"][0];
    EXPECT_EQ(frame["properties"]["area_m2"], 1500.0);
    ASSERT_EQ(frame["geometry"]["coordinates"].size(), 2u);
    EXPECT_EQ(frame["geometry"]["coordinates"][0][0], nlohmann::json({105.0, 205.0}));
    EXPECT_EQ(frame["geometry"]["coordinates"][1].size(), 5u);  // the hole is a square
    for (const auto& ring : frame["geometry"]["coordinates"]) EXPECT_EQ(ring.front(), ring.back());
    EXPECT_EQ(json["features"][1]["properties"]["area_m2"], 100.0);
}

TEST(Export, keeps_a_ring_apart_from_the_hole_it_touches) {
    const support::TemporaryFolder folder;
    const sim::Grid grid{5, 5, 10.f};
    // .##.
    // #.#.   the hole touches the outside in the north-west corner of its cell
    // ###.
    std::vector<std::uint8_t> mask(grid.size());
    for (const int cell : {0 * 5 + 0, 0 * 5 + 1, 0 * 5 + 2, 1 * 5 + 0, 1 * 5 + 2, 2 * 5 + 1, 2 * 5 + 2})
        mask[cell] = 1;
    ASSERT_TRUE(write_outlines(folder.path() / "mask.geojson", grid, Georeference::unnamed(0, 0), mask));
    const auto json = nlohmann::json::parse(test::read_text(folder.path() / "mask.geojson"));
    ASSERT_EQ(json["features"].size(), 1u);
    EXPECT_EQ(json["features"][0]["properties"]["area_m2"], 700.0);
    const auto& rings = json["features"][0]["geometry"]["coordinates"];
    ASSERT_EQ(rings.size(), 2u);
    EXPECT_EQ(rings[0].size(), 7u);
    EXPECT_EQ(rings[1].size(), 5u);
}

TEST(Export, writes_an_empty_mask_as_no_features) {
    const support::TemporaryFolder folder;
    ASSERT_TRUE(write_outlines(folder.path() / "mask.geojson", kGrid, places()[0],
                               std::vector<std::uint8_t>(kGrid.size())));
    EXPECT_TRUE(nlohmann::json::parse(test::read_text(folder.path() / "mask.geojson"))["features"].empty());
}

TEST(Export, names_the_file_it_cannot_write_and_leaves_no_file) {
    const support::TemporaryFolder folder;
    const auto nowhere = folder.path() / "none";
    const auto tif = write_geotiff(nowhere / "field.tif", kGrid, {}, bumps());
    const auto asc = write_ascii(nowhere / "field.asc", kGrid, {}, bumps());
    const auto json =
        write_outlines(nowhere / "mask.geojson", kGrid, {}, std::vector<std::uint8_t>(kGrid.size(), 1));
    for (const auto& written : {tif, asc, json}) {
        ASSERT_FALSE(written);
        EXPECT_NE(written.error().find("cannot be written"), std::string::npos) << written.error();
    }
    std::filesystem::create_directory(folder.path() / "field.asc");  // a folder in the way
    EXPECT_FALSE(write_ascii(folder.path() / "field.asc", kGrid, {}, bumps()));
    ASSERT_TRUE(write_geotiff(folder.path() / "field.tif", kGrid, {}, bumps()));
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        EXPECT_NE(entry.path().extension(), ".part") << entry.path();
}

}  // namespace
}  // namespace terrains
