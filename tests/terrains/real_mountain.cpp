// The data that COULOIR_DEM_DIR names: one mountain in three coordinate systems, and a hillside without any.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <string>
#include <vector>

#include "terrains/dem_gdal.h"
#include "terrains/release.h"
#include "tests/support/places.h"
#include "tests/terrains/files.h"

namespace terrains {
namespace {

class RealMountain : public testing::Test {
  protected:
    void SetUp() override {
        if (!support::dem_dir()) GTEST_SKIP() << "COULOIR_DEM_DIR is not set";
    }
    static std::filesystem::path file(const std::string& name) { return *support::dem_dir() / name; }
    static std::vector<Terrain> alplehner(int squares) {
        std::vector<Terrain> all;
        for (const char* name : {"alr/alr.asc", "alr/alr_utm32n.tif", "alr/alr_wgs84.tif"})
            all.push_back(read_dem(file(name), squares).value());
        return all;
    }
};

double volume(const Terrain& terrain, const std::vector<float>& thickness) {
    return std::accumulate(thickness.begin(), thickness.end(), 0.0) * terrain.grid.cell_area();
}

TEST_F(RealMountain, stands_in_the_same_place_in_three_coordinate_systems) {
    const auto all = alplehner(900);  // cells of about 5 m, as in the files
    for (std::size_t other = 1; other < all.size(); ++other) {
        std::vector<double> differences;
        for (int row = 0; row < 95; ++row)
            for (int column = 0; column < 41; ++column) {
                const LatLon there{47.2815 + 0.0004 * row, 11.4185 + 0.0006 * column};
                const auto height = [&](const Terrain& terrain) {
                    const auto p = terrain.georeference.to_local(there);
                    return p ? test::height_at(terrain, *p) : std::nan("");
                };
                const double difference = height(all[other]) - height(all[0]);
                if (!std::isnan(difference)) differences.push_back(std::abs(difference));
            }
        ASSERT_GT(differences.size(), 1500u);
        std::sort(differences.begin(), differences.end());
        // A shift of one cell is some 4 m of height here. The files were resampled from each other, so they
        // agree no better.
        EXPECT_LT(differences[differences.size() / 2], 0.1) << all[other].name << ": median, m";
        EXPECT_LT(differences[differences.size() * 99 / 100], 1.5) << all[other].name << ": 99 %, m";
    }
}

TEST_F(RealMountain, releases_the_same_volume_in_three_coordinate_systems) {
    constexpr double kArea = 41'025;  // m² in plan, thickness 1 m
    for (const int squares : {80, 160, 320})
        for (const Terrain& terrain : alplehner(squares)) {
            const auto thickness = test::thickness_in(file("alr/release.geojson"), terrain);
            ASSERT_TRUE(thickness) << thickness.error();
            EXPECT_NEAR(volume(terrain, *thickness), kArea, 0.01 * kArea)
                << terrain.name << " at " << squares;
        }
}

TEST_F(RealMountain, has_the_reference_extent_below_its_release) {
    for (const Terrain& terrain : alplehner(400)) {
        const auto extent = test::extent_in(file("alr/reference_extent.geojson"), terrain);
        ASSERT_TRUE(extent) << extent.error();
        const double hectares = static_cast<double>(std::accumulate(extent->begin(), extent->end(), 0L)) *
                                terrain.grid.cell_area() / 1e4;
        EXPECT_NEAR(hectares, 26.0, 0.8) << terrain.name;
    }
}

TEST_F(RealMountain, reports_its_no_data) {
    const auto terrain = read_dem(file("alr/alr.asc"), 400).value();
    const auto known = std::accumulate(terrain.has_data.begin(), terrain.has_data.end(), 0.0);
    EXPECT_NEAR(1 - known / static_cast<double>(terrain.grid.size()), 0.31, 0.01);
    for (const float height : terrain.surface) ASSERT_TRUE(height > 300 && height < 2800) << height;
}

TEST_F(RealMountain, finds_its_landslide_by_coordinates_without_a_system) {
    std::ifstream file_of_depths(file("landslide/landslide_depth.asc"));
    std::string key;
    double value = 0, truth = 0;
    for (int line = 0; line < 6; ++line) file_of_depths >> key >> value;
    while (file_of_depths >> value)
        if (value != -9999) truth += -value * 100;  // pixels of 10 m
    ASSERT_GT(truth, 1000);
    for (const int squares : {60, 121, 240}) {
        const auto terrain = read_dem(file("landslide/pre_runout_DEM.asc"), squares).value();
        EXPECT_FALSE(terrain.georeference.placed());
        const auto thickness = test::thickness_in(file("landslide/landslide_depth.asc"), terrain);
        ASSERT_TRUE(thickness) << thickness.error();
        EXPECT_NEAR(volume(terrain, *thickness), truth, 0.01 * truth) << squares;
    }
}

}  // namespace
}  // namespace terrains
