#include "terrains/dem_gdal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include <fmt/format.h>

#include "terrains/export.h"
#include "tests/support/places.h"
#include "tests/terrains/files.h"

namespace terrains {
namespace {

using test::AsciiGrid;

constexpr double kEast = 683'000, kNorth = 5'240'000;  // in UTM 32N, in Tyrol

double plane(double x, double y) {
    return 1500 + 0.5 * (x - kEast) - 0.25 * (y - kNorth);
}

// Calls check(vertex's local point, its height) wherever the terrain has data, and counts the calls.
int for_known(const Terrain& terrain, const std::function<void(LocalPoint, double)>& check) {
    int known = 0;
    for (int y = 0; y < terrain.grid.ny; ++y)
        for (int x = 0; x < terrain.grid.nx; ++x) {
            const auto at = static_cast<std::size_t>(y) * terrain.grid.nx + x;
            if (terrain.has_data[at] == 0) continue;
            ++known;
            check({x * static_cast<double>(terrain.grid.dx), y * static_cast<double>(terrain.grid.dx)},
                  terrain.surface[at]);
        }
    return known;
}

TEST(Dem, reproduces_a_plane_in_metres_exactly_with_its_own_axes) {
    const support::TemporaryFolder folder;
    const auto path = test::write_ascii_grid(folder.path(), "hill",
                                             {.west = kEast, .south = kNorth, .prj = test::utm_32n()}, plane);
    for (const int squares : {8, 20, 33, 80}) {
        const auto terrain = read_dem(path, squares);
        ASSERT_TRUE(terrain) << terrain.error();
        EXPECT_EQ(terrain->name, "hill.asc");
        EXPECT_EQ(terrain->grid.nx, squares + 1);
        EXPECT_DOUBLE_EQ(terrain->georeference.origin_x(), kEast);
        EXPECT_DOUBLE_EQ(terrain->georeference.origin_y(), kNorth);
        EXPECT_TRUE(terrain->georeference.placed());
        const int known = for_known(*terrain, [](LocalPoint p, double height) {
            ASSERT_NEAR(height, plane(kEast + p.x, kNorth + p.y), 3e-4);
        });
        EXPECT_EQ(known, static_cast<int>(terrain->grid.size()));
    }
}

TEST(Dem, reproduces_a_plane_in_degrees_exactly_on_its_local_plane) {
    const support::TemporaryFolder folder;
    AsciiGrid grid{
        .columns = 31, .rows = 41, .west = 11.42, .south = 47.29, .cell = 0.0001, .prj = test::degrees()};
    const auto truth = Georeference::local({47.292, 11.4215}, 0, 0);
    const auto path =
        test::write_ascii_grid(folder.path(), "hill", grid, [&](double longitude, double latitude) {
            const auto p = truth.to_local({latitude, longitude}).value();
            return 1500 + 0.5 * p.x - 0.25 * p.y;
        });
    for (const int squares : {16, 40, 90}) {
        const auto terrain = read_dem(path, squares);
        ASSERT_TRUE(terrain) << terrain.error();
        const int known = for_known(*terrain, [&](LocalPoint p, double height) {
            const double x = p.x + terrain->georeference.origin_x(),
                         y = p.y + terrain->georeference.origin_y();
            ASSERT_NEAR(height, 1500 + 0.5 * x - 0.25 * y, 1e-3)
                << squares << " squares at " << p.x << ", " << p.y;
        });
        EXPECT_EQ(known, static_cast<int>(terrain->grid.size()));
        // 40 rows of 0.0001° of latitude: 11.12 m each at 47° N.
        EXPECT_NEAR(terrain->grid.dx * (terrain->grid.ny - 1), 40 * 11.118, 0.1);
    }
}

TEST(Dem, reproduces_a_plane_without_a_coordinate_system_exactly) {
    const support::TemporaryFolder folder;
    const auto path = test::write_ascii_grid(folder.path(), "hill", {.west = kEast, .south = kNorth}, plane);
    const auto terrain = read_dem(path, 33);
    ASSERT_TRUE(terrain) << terrain.error();
    EXPECT_FALSE(terrain->georeference.placed());
    EXPECT_DOUBLE_EQ(terrain->georeference.origin_x(), kEast);
    const int known = for_known(*terrain, [](LocalPoint p, double height) {
        ASSERT_NEAR(height, plane(kEast + p.x, kNorth + p.y), 3e-4);
    });
    EXPECT_EQ(known, static_cast<int>(terrain->grid.size()));
}

TEST(Dem, projects_feet_to_a_plane_in_metres) {
    const support::TemporaryFolder folder;
    constexpr double kFoot = 0.3048;
    AsciiGrid grid{
        .west = kEast / kFoot, .south = kNorth / kFoot, .cell = 30, .prj = test::utm_32n_in_feet()};
    const auto path = test::write_ascii_grid(folder.path(), "hill", grid,
                                             [&](double x, double y) { return plane(x * kFoot, y * kFoot); });
    const auto terrain = read_dem(path, 20);
    ASSERT_TRUE(terrain) << terrain.error();
    EXPECT_NEAR(terrain->grid.dx, 30 * kFoot, 0.3);  // north is 1.8° off here, and corners are cut
    const auto utm = Georeference::projected(test::utm_32n(), 0, 0);
    const int known = for_known(*terrain, [&](LocalPoint p, double height) {
        const auto there = utm.to_local(terrain->georeference.to_lat_lon(p).value()).value();
        ASSERT_NEAR(height, plane(there.x, there.y), 2e-3);
    });
    EXPECT_GT(known, static_cast<int>(terrain->grid.size()) * 9 / 10);
}

TEST(Dem, converts_web_mercator_to_true_metres) {
    const support::TemporaryFolder folder;
    AsciiGrid grid{.west = 1'272'000, .south = 5'990'000, .prj = test::web_mercator()};  // 47.3° N
    const auto path =
        test::write_ascii_grid(folder.path(), "hill", grid, [](double, double) { return 700.0; });
    const auto terrain = read_dem(path, 20);
    ASSERT_TRUE(terrain) << terrain.error();
    const double latitude = terrain->georeference.to_lat_lon({0, 0}).value().latitude;
    EXPECT_NEAR(terrain->grid.dx, 10 * std::cos(latitude * 3.14159265 / 180), 0.03);
}

TEST(Dem, reads_feet_scale_and_offset_of_heights) {
    const support::TemporaryFolder folder;
    test::write_ascii_grid(folder.path(), "hill", {}, [](double x, double) { return 1000 + x; });
    const auto wrapped = [&](const std::string& band) {
        test::write_text(
            folder.path() / "hill.vrt",
            "<VRTDataset rasterXSize=\"21\" rasterYSize=\"17\"><GeoTransform>-5,10,0,165,0,-10</GeoTransform>"
            "<VRTRasterBand dataType=\"Float32\" band=\"1\">" +
                band +
                "<SimpleSource><SourceFilename relativeToVRT=\"1\">hill.asc</SourceFilename></SimpleSource>"
                "</VRTRasterBand></VRTDataset>");
        return read_dem(folder.path() / "hill.vrt", 20, References::kAllowed);
    };
    const auto feet = wrapped("<UnitType>ft</UnitType>");
    ASSERT_TRUE(feet) << feet.error();
    EXPECT_NEAR(feet->surface[7], (1000 + 70) * 0.3048, 1e-3);
    const auto scaled = wrapped("<Offset>100</Offset><Scale>0.5</Scale>");
    ASSERT_TRUE(scaled) << scaled.error();
    EXPECT_NEAR(scaled->surface[7], 100 + (1000 + 70) * 0.5, 1e-3);
    const auto cubits = wrapped("<UnitType>cubit</UnitType>");
    ASSERT_FALSE(cubits);
    EXPECT_NE(cubits.error().find("'cubit'"), std::string::npos) << cubits.error();
}

TEST(Dem, reads_a_raster_whose_rows_run_north) {
    const support::TemporaryFolder folder;
    test::write_ascii_grid(folder.path(), "hill", {}, [](double, double y) { return 1000 + y; });
    test::write_text(
        folder.path() / "hill.vrt",
        "<VRTDataset rasterXSize=\"21\" rasterYSize=\"17\"><GeoTransform>-5,10,0,-5,0,10</GeoTransform>"
        "<VRTRasterBand dataType=\"Float32\" band=\"1\"><SimpleSource><SourceFilename relativeToVRT=\"1\">"
        "hill.asc</SourceFilename></SimpleSource></VRTRasterBand></VRTDataset>");
    const auto terrain = read_dem(folder.path() / "hill.vrt", 20, References::kAllowed);
    ASSERT_TRUE(terrain) << terrain.error();
    EXPECT_NEAR(terrain->surface.front(), 1160, 1e-3);  // the file's first row is the south one now
    EXPECT_NEAR(terrain->surface.back(), 1000, 1e-3);
}

TEST(Dem, accepts_every_form_of_no_data) {
    const support::TemporaryFolder folder;
    const AsciiGrid grid{.is_void = [](int column, int row) { return column == 3 && row == 5; }};
    const std::string plain = test::ascii_text(grid, [](double x, double) { return 1000 + x; });
    const auto spelt = [&](const std::string& header, const std::string& value) {
        std::string text = plain;
        text.replace(text.find("NODATA_value -9999\n"), 19, header);
        text.replace(text.find("-9999.000000"), 12, value);
        test::write_text(folder.path() / "hill.asc", text);
        return read_dem(folder.path() / "hill.asc", 20);
    };
    for (const auto& [header, value] : {std::pair{"NODATA_value -9999\n", "-9999"},
                                        {"nodata_value 0\n", "0"},
                                        {"", "-9999"},
                                        {"", "nan"},
                                        {"NODATA_VALUE -9999\n", "nan"},
                                        {"NODATA_value nan\n", "nan"},
                                        {"", "-32768"},
                                        {"NODATA_value -3.4e38\n", "-3.4e38"}}) {
        const auto terrain = spelt(header, value);
        ASSERT_TRUE(terrain) << header << value << ": " << terrain.error();
        int voids = 0;
        for (const auto known : terrain->has_data) voids += known == 0 ? 1 : 0;
        EXPECT_EQ(voids, 1) << header << value;
        const std::size_t hole = 11 * 21 + 3;
        EXPECT_EQ(terrain->has_data[hole], 0) << header << value;
        EXPECT_NEAR(terrain->surface[hole], 1030, 1e-3) << "the neighbours' slope is extended";
    }
}

TEST(Dem, accepts_header_keys_in_any_case_and_corner_or_centre) {
    const support::TemporaryFolder folder;
    const AsciiGrid grid{.west = 100, .south = 200, .cell = 4.9977};
    const std::string plain = test::ascii_text(grid, [](double x, double y) { return 1000 + x - y; });
    test::write_text(folder.path() / "hill.asc", plain);
    const auto expected = read_dem(folder.path() / "hill.asc", 20).value();
    const std::string body = plain.substr(plain.find("NODATA_value -9999\n") + 19);
    for (const std::string header : {
             "NCOLS 21\nNROWS 17\nXLLCENTER 100\nYLLCENTER 200\nCELLSIZE 4.9977\nNODATA_VALUE -9999\n",
             "ncols         21\r\nnrows         17\r\nxllcorner 97.50115\r\nyllcorner 197.50115\r\ncellsize "
             "4.9977\r\n",
             "nrows\t17\nncols\t21\nyllcenter\t200\nxllcenter\t100\ncellsize\t4.9977\nnodata_value\t-9999\n",
             "nCols 21\nnRows 17\nXLLCorner 97.50115\nYLLCorner 197.50115\nDX 4.9977\nDY 4.9977\n",
         }) {
        test::write_text(folder.path() / "hill.asc", header + body);
        const auto terrain = read_dem(folder.path() / "hill.asc", 20);
        ASSERT_TRUE(terrain) << header << terrain.error();
        EXPECT_EQ(terrain->grid, expected.grid) << header;
        EXPECT_EQ(terrain->surface, expected.surface) << header;
        EXPECT_NEAR(terrain->georeference.origin_x(), 100, 1e-9) << header;
        EXPECT_NEAR(terrain->georeference.origin_y(), 200, 1e-9) << header;
    }
    EXPECT_NEAR(expected.grid.dx, 4.9977, 1e-6);
}

TEST(Dem, refuses_an_ascii_grid_cut_short_anywhere_and_prints_nothing) {
    const support::TemporaryFolder folder;
    const std::string whole =
        test::ascii_text({.columns = 9, .rows = 9}, [](double x, double y) { return 1000 + x + y; });
    const auto path = folder.path() / "hill.asc";
    test::write_text(path, whole);
    ASSERT_TRUE(read_dem(path, 8));
    const std::size_t last_number = whole.find_last_of(' ') + 1;  // a cut within it cannot be detected
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    std::string passed;
    for (std::size_t length = 0; length <= last_number; ++length) {
        test::write_text(path, whole.substr(0, length));
        const auto terrain = read_dem(path, 8);
        if (terrain)
            passed += fmt::format(" {}", length);
        else if (terrain.error().find("hill.asc: ") == std::string::npos)
            passed += " unnamed:" + terrain.error();
    }
    EXPECT_EQ(passed, "") << "it was read when cut to these lengths, of " << whole.size();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(Dem, refuses_a_geotiff_cut_short_anywhere_and_prints_nothing) {
    const support::TemporaryFolder folder;
    const sim::Grid grid{60, 50, 10.f};
    std::vector<float> field(grid.size());
    for (std::size_t i = 0; i < field.size(); ++i)
        field[i] = 1000 + 100 * std::sin(static_cast<float>(i * i % 977));
    const auto path = folder.path() / "hill.tif";
    ASSERT_TRUE(write_geotiff(path, grid, Georeference::projected(test::utm_32n(), kEast, kNorth), field));
    ASSERT_TRUE(read_dem(path, 20));
    const std::string whole = test::read_text(path);
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    std::string passed;
    for (std::size_t length = 0; length < whole.size(); length += length < 600 ? 7 : 97) {
        test::write_text(path, whole.substr(0, length));
        if (read_dem(path, 20)) passed += fmt::format(" {}", length);
    }
    test::write_text(path, whole.substr(0, whole.size() - 1));
    if (read_dem(path, 20)) passed += " all but one";
    EXPECT_EQ(passed, "") << "it was read when cut to these lengths, of " << whole.size();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(Dem, errors_name_file_and_fact) {
    const support::TemporaryFolder folder;
    const auto refusal = [&](const std::string& text, int squares = 8) {
        test::write_text(folder.path() / "bad.asc", text);
        const auto terrain = read_dem(folder.path() / "bad.asc", squares);
        return terrain ? "it was read" : terrain.error();
    };
    const auto flat = [](double height) {
        return test::ascii_text({}, [height](double, double) { return height; });
    };
    const auto header = [](const std::string& columns, const std::string& rows, const std::string& cell) {
        return "ncols " + columns + "\nnrows " + rows + "\nxllcorner 0\nyllcorner 0\ncellsize " + cell +
               "\n1 2 3\n";
    };
    const auto expect = [](const std::string& said, const std::string& fact) {
        EXPECT_NE(said.find("bad.asc: "), std::string::npos) << said;
        EXPECT_NE(said.find(fact), std::string::npos) << said;
        EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    };
    expect(refusal("a letter to my aunt"), "raster");
    expect(refusal(flat(-9999)), "no data anywhere");
    expect(refusal(flat(9001)), "row 1, column 1 is 9001 m high");
    expect(refusal(flat(-12001)), "row 1, column 1 is -12001 m high");
    std::string infinite = flat(5);
    infinite.replace(infinite.rfind("5.000000"), 8, "inf");
    expect(refusal(infinite), "row 17, column 21 is");
    expect(refusal(flat(5) + "5\n"), "358 numbers where its header promises 357");
    expect(refusal(flat(5), 7), "8 to 4096");
    expect(refusal(flat(5), 5000), "8 to 4096");
    expect(refusal(header("30000", "30000", "1")), "400 million");
    expect(refusal(header("200000", "3", "1")), "100000");
    const auto missing = read_dem(folder.path() / "none.asc", 20);
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error(), (folder.path() / "none.asc").string() + ": there is no such file");
}

TEST(Dem, refuses_impossible_pixel_sizes_and_coordinates) {
    const support::TemporaryFolder folder;
    const auto refusal = [&](double west, double cell) {
        const auto terrain =
            read_dem(test::write_ascii_grid(folder.path(), "odd", {.west = west, .south = 5e6, .cell = cell},
                                            [](double, double) { return 5.0; }),
                     20);
        return terrain ? "it was read" : terrain.error();
    };
    for (const double cell : {1e-150, 1e-12, 9e-4, 2e6, 1e150})
        EXPECT_NE(refusal(6e5, cell).find("its pixels are"), std::string::npos) << refusal(6e5, cell);
    for (const double west : {2e9, -2e9, 1e300})
        EXPECT_NE(refusal(west, 5).find("m from the origin of its coordinates"), std::string::npos)
            << refusal(west, 5);
    EXPECT_EQ(refusal(6e5, 0.01), "it was read");
}

TEST(Dem, refuses_degrees_that_span_too_much_or_are_not_declared) {
    const support::TemporaryFolder folder;
    const auto flat = [](double, double) { return 5.0; };
    const auto wide = read_dem(
        test::write_ascii_grid(folder.path(), "wide",
                               {.west = 10, .south = 46, .cell = 0.11, .prj = test::degrees()}, flat),
        20);
    ASSERT_FALSE(wide);
    EXPECT_NE(wide.error().find("spans 2.31°"), std::string::npos) << wide.error();
    const auto undeclared = read_dem(
        test::write_ascii_grid(folder.path(), "bare", {.west = 10, .south = 46, .cell = 0.0001}, flat), 20);
    ASSERT_FALSE(undeclared);
    EXPECT_NE(undeclared.error().find("looks like degrees"), std::string::npos) << undeclared.error();
}

}  // namespace
}  // namespace terrains
