// What a raster's numbers mean: unit, scale, offset, no data, colours; for every use, through one reader.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <cpl_string.h>
#include <gdal.h>
#include <gtest/gtest.h>
#include <ogr_srs_api.h>

#include "terrains/dem_gdal.h"
#include "terrains/gdal_support.h"
#include "terrains/release.h"
#include "tests/support/places.h"
#include "tests/terrains/files.h"
#include "tests/terrains/memory_files.h"

namespace terrains {
namespace {

namespace fs = std::filesystem;

constexpr int kColumns = 41, kRows = 31;
constexpr double kWest = 683'000, kNorth = 5'240'000, kCell = 10;

// A GeoTIFF with all that a raster may state about its numbers.
struct Stated {
    GDALDataType type = GDT_Float32;
    std::function<double(int column, int row, int band)> value = [](int, int, int) { return 3.0; };
    const char* unit = "";
    double scale = 1, offset = 0;
    std::optional<double> no_data = {};
    std::vector<GDALColorInterp> colours = {GCI_GrayIndex};  // one per band
    std::vector<std::string> options = {};
    std::string vertical = {};  // "EPSG:6360", a vertical system besides UTM 32N
    int rows_written = kRows;
    bool palette = false;
};

class RasterStates : public testing::Test {
  protected:
    RasterStates() { ground_.value(); }

    fs::path write(const Stated& stated, const char* driver = "GTiff", const char* name = "stated.tif") {
        const GdalErrors registered;
        char** options = nullptr;
        for (const std::string& option : stated.options) options = CSLAddString(options, option.c_str());
        {
            const Dataset made(GDALCreate(GDALGetDriverByName("GTiff"), "/vsimem/made/stated.tif", kColumns,
                                          kRows, static_cast<int>(stated.colours.size()), stated.type,
                                          options));
            fill(stated, made.get());
            if (std::string(driver) != "GTiff")
                Dataset(GDALCreateCopy(GDALGetDriverByName(driver),
                                       (std::string("/vsimem/copy/") + name).c_str(), made.get(), FALSE,
                                       nullptr, nullptr, nullptr));
        }
        CSLDestroy(options);
        const auto written = test::unload("/vsimem/made", folder_.path());
        if (std::string(driver) == "GTiff") return folder_.path() / "stated.tif";
        test::unload("/vsimem/copy", folder_.path());
        return folder_.path() / name;
    }

    static void fill(const Stated& stated, GDALDatasetH made) {
        std::array<double, 6> pixels{kWest - kCell / 2, kCell, 0, kNorth + kCell / 2, 0, -kCell};
        GDALSetGeoTransform(made, pixels.data());
        const std::string code = stated.vertical.empty() ? "EPSG:32632" : "EPSG:32632+" + stated.vertical;
        OGRSpatialReferenceH system = OSRNewSpatialReference(nullptr);
        ASSERT_EQ(OSRSetFromUserInput(system, code.c_str()), OGRERR_NONE);
        GDALSetSpatialRef(made, system);
        OSRDestroySpatialReference(system);
        for (int band = 1; band <= GDALGetRasterCount(made); ++band) {
            GDALRasterBandH into = GDALGetRasterBand(made, band);
            GDALSetRasterColorInterpretation(into, stated.colours[static_cast<std::size_t>(band - 1)]);
            if (band == 1) {
                if (*stated.unit != '\0') GDALSetRasterUnitType(into, stated.unit);
                if (stated.scale != 1) GDALSetRasterScale(into, stated.scale);
                if (stated.offset != 0) GDALSetRasterOffset(into, stated.offset);
                if (stated.no_data) GDALSetRasterNoDataValue(into, *stated.no_data);
                if (stated.palette) {
                    GDALColorTableH colours = GDALCreateColorTable(GPI_RGB);
                    const GDALColorEntry green{0, 128, 0, 255};
                    GDALSetColorEntry(colours, 3, &green);
                    GDALSetRasterColorTable(into, colours);
                    GDALDestroyColorTable(colours);
                }
            }
            for (int row = 0; row < stated.rows_written; ++row) {
                std::array<double, kColumns> values{};
                for (int column = 0; column < kColumns; ++column)
                    values[static_cast<std::size_t>(column)] = stated.value(column, row, band);
                ASSERT_EQ(GDALRasterIO(into, GF_Write, 0, row, kColumns, 1, values.data(), kColumns, 1,
                                       GDT_Float64, 0, 0),
                          CE_None);
            }
        }
    }

    // The least and the greatest value where the raster has one, away from its border, where half of a pixel counts as
    // being beyond it; for each use; NaN where it is refused.
    struct Range {
        double low, high;
    };
    struct Uses {
        Range height, release, reference;
        std::string error;  // the first one
    };
    Uses uses(const fs::path& path) {
        Uses result{};
        const auto range = [&](const auto& read, const auto& field) {
            if (!read) {
                if (result.error.empty()) result.error = read.error();
                return Range{std::nan(""), std::nan("")};
            }
            Range found{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
            const std::vector<float> values = field(*read);
            for (std::size_t y = 1; y + 1 < kRows; ++y)
                for (std::size_t x = 1; x + 1 < kColumns; ++x) {
                    const double value = values[y * kColumns + x];
                    found.low = std::min(found.low, value);
                    found.high = std::max(found.high, value);
                }
            return found;
        };
        result.height = range(read_dem(path, GridChoice::kOwn), [](const Terrain& t) { return t.surface; });
        result.release = range(read_release(path, *ground_), [](const Release& r) { return r.thickness; });
        result.reference = range(read_reference(path, *ground_), [](const Reference& r) { return r.change; });
        return result;
    }

    // All three uses read the same number at every pixel.
    void expect_read_as(double metres, const Stated& stated, const std::string& what) {
        const Uses read = uses(write(stated));
        ASSERT_EQ(read.error, "") << what;
        for (const Range& range : {read.height, read.release, read.reference}) {
            EXPECT_NEAR(range.low, metres, 1e-4 * metres) << what;
            EXPECT_NEAR(range.high, metres, 1e-4 * metres) << what;
        }
    }
    void expect_refused(const fs::path& path, const std::string& fact) {
        const Uses read = uses(path);
        for (const Range& range : {read.height, read.release, read.reference})
            EXPECT_TRUE(std::isnan(range.low)) << path << " " << fact;
        EXPECT_NE(read.error.find(fact), std::string::npos) << read.error;
    }

    support::TemporaryFolder folder_;
    tl::expected<Terrain, std::string> ground_ =
        read_dem(test::write_ascii_grid(folder_.path(), "ground",
                                        {.columns = kColumns,
                                         .rows = kRows,
                                         .west = kWest,
                                         .south = kNorth - (kRows - 1) * kCell,
                                         .cell = kCell,
                                         .prj = test::utm_32n()},
                                        [](double, double) { return 500.0; }),
                 GridChoice::kOwn);
};

TEST_F(RasterStates, unit_scale_and_offset_for_every_use) {
    constexpr double kFoot = 0.3048, kSurveyFoot = 1200.0 / 3937.0;
    expect_read_as(3, {}, "nothing");
    for (const auto& [unit, metres] : {std::pair{"m", 1.0},
                                       {"metre", 1.0},
                                       {"Metre", 1.0},
                                       {"cm", 0.01},
                                       {"mm", 0.001},
                                       {"dm", 0.1},
                                       {"ft", kFoot},
                                       {"Foot", kFoot},
                                       {"US survey foot", kSurveyFoot}})
        expect_read_as(3 * metres, {.unit = unit}, unit);
    const auto thirty = [](int, int, int) { return 30.0; };
    expect_read_as(0.3, {.type = GDT_Int16, .value = thirty, .scale = 0.01}, "scale");
    expect_read_as(32, {.type = GDT_Int16, .value = thirty, .offset = 2}, "offset");
    expect_read_as((30 * 0.01 + 2) * kFoot,
                   {.type = GDT_UInt16, .value = thirty, .unit = "ft", .scale = 0.01, .offset = 2}, "all");
    for (const char* unit : {"yd", "fathom", "kPa", "%", "m/s"})
        expect_refused(write({.unit = unit}), "neither metres nor feet");
}

TEST_F(RasterStates, heights_of_its_vertical_system_for_every_use) {
    expect_read_as(3, {.vertical = "5773"}, "EGM96");
    expect_read_as(3 * 1200.0 / 3937.0, {.vertical = "6360"}, "NAVD88 in US survey feet");
    expect_read_as(3 * 0.3048, {.vertical = "8228"}, "NAVD88 in feet");
    expect_refused(write({.vertical = "5715"}), "downwards");
}

TEST_F(RasterStates, no_data_in_every_way_for_every_use) {
    // The left ten columns are unknown.
    const auto left = [](double there) {
        return [there](int column, int, int) { return column < 10 ? there : 3.0; };
    };
    const auto alpha = [](int column, int, int band) {
        return band == 2 ? (column < 10 ? 0.0 : 255.0) : column < 10 ? 77.0 : 3.0;
    };
    const std::vector<GDALColorInterp> with_alpha{GCI_GrayIndex, GCI_AlphaBand};
    std::vector<std::pair<std::string, Stated>> ways;
    ways.push_back({"declared", {.value = left(42), .no_data = 42}});
    ways.push_back({"declared, in feet", {.value = left(-77), .no_data = -77}});
    ways.push_back({"nan", {.value = left(std::nan(""))}});
    ways.push_back({"-9999", {.value = left(-9999)}});
    ways.push_back({"-32768", {.type = GDT_Int16, .value = left(-32768)}});
    ways.push_back({"alpha of floats", {.value = alpha, .colours = with_alpha}});
    ways.push_back({"alpha of doubles", {.type = GDT_Float64, .value = alpha, .colours = with_alpha}});
    ways.push_back({"alpha of 32 bits", {.type = GDT_Int32, .value = alpha, .colours = with_alpha}});
    ways.push_back({"alpha of 16 bits", {.type = GDT_UInt16, .value = alpha, .colours = with_alpha}});
    ways.push_back({"alpha of 8 bits", {.type = GDT_Byte, .value = alpha, .colours = with_alpha}});
    ways.push_back(
        {"alpha, and another value declared", {.value = alpha, .no_data = 99, .colours = with_alpha}});
    for (const auto& [what, stated] : ways) {
        const auto path = write(stated);
        const auto terrain = read_dem(path, GridChoice::kOwn);
        ASSERT_TRUE(terrain) << what << terrain.error();
        const auto release = read_release(path, *ground_);
        ASSERT_TRUE(release) << what << release.error();
        const auto reference = read_reference(path, *ground_);
        ASSERT_TRUE(reference) << what << reference.error();
        for (int y = 1; y + 1 < kRows; ++y) {
            const std::size_t i = static_cast<std::size_t>(y) * kColumns;
            EXPECT_EQ(terrain->has_data[i + 8], 0) << what;
            EXPECT_EQ(terrain->has_data[i + 12], 1) << what;
            EXPECT_EQ(terrain->surface[i + 12], 3.f) << what;
            EXPECT_EQ(release->thickness[i + 8], 0.f) << what;
            EXPECT_EQ(release->thickness[i + 12], 3.f) << what;
            EXPECT_EQ(reference->change[i + 8], 0.f) << what;
        }
    }
}

TEST_F(RasterStates, blocks_that_are_missing_as_no_data) {
    const auto path = write({.options = {"SPARSE_OK=TRUE", "BLOCKYSIZE=8"}, .rows_written = 16});
    const auto terrain = read_dem(path, GridChoice::kOwn);
    ASSERT_TRUE(terrain) << terrain.error();
    EXPECT_EQ(terrain->has_data[0], 0);
    EXPECT_EQ(terrain->has_data[static_cast<std::size_t>(kRows - 1) * kColumns], 1);
}

TEST_F(RasterStates, colours_and_is_refused_for_every_use) {
    const std::vector<GDALColorInterp> rgb{GCI_RedBand, GCI_GreenBand, GCI_BlueBand};
    const std::vector<GDALColorInterp> rgba{GCI_RedBand, GCI_GreenBand, GCI_BlueBand, GCI_AlphaBand};
    expect_refused(write({.type = GDT_Byte, .colours = rgb, .options = {"PHOTOMETRIC=RGB"}}),
                   "Red of an image");
    expect_refused(write({.type = GDT_Byte, .colours = rgba, .options = {"PHOTOMETRIC=RGB", "ALPHA=YES"}}),
                   "Red of an image");
    expect_refused(write({.type = GDT_UInt16, .colours = rgb, .options = {"PHOTOMETRIC=RGB"}}),
                   "Red of an image");
    expect_refused(write({.type = GDT_Byte, .palette = true}), "palette");
    expect_refused(write({.type = GDT_Byte, .colours = {GCI_GrayIndex, GCI_Undefined, GCI_Undefined}}),
                   "3 bands of 8 bits");
    expect_refused(
        write({.type = GDT_Byte, .colours = rgb, .options = {"PHOTOMETRIC=RGB"}}, "JPEG", "photo.jpg"),
        "of an image");
    expect_refused(
        write({.type = GDT_Byte, .colours = rgb, .options = {"PHOTOMETRIC=RGB"}}, "PNG", "photo.png"),
        "of an image");
    expect_refused(
        write({.type = GDT_Byte, .colours = rgb, .options = {"PHOTOMETRIC=RGB"}}, "JP2OpenJPEG", "photo.jp2"),
        "of an image");
}

TEST_F(RasterStates, shares_of_a_wood_without_a_unit_or_in_per_cent) {
    const auto share = [&](const Stated& stated) {
        return read_dem(write(stated), GridChoice::kOwn, References::kRefused, Quantity::kShare)
            .map([](const Terrain& t) { return static_cast<double>(t.surface[500]); });
    };
    EXPECT_NEAR(share({.value = [](int, int, int) { return 0.25; }}).value(), 0.25, 1e-6);
    EXPECT_NEAR(share({.value = [](int, int, int) { return 25; }, .unit = "%"}).value(), 0.25, 1e-6);
    EXPECT_FALSE(share({.value = [](int, int, int) { return 25; }}));
    EXPECT_FALSE(share({.value = [](int, int, int) { return 0.25; }, .unit = "m"}));
}

TEST_F(RasterStates, a_cliff_that_is_a_value_for_no_data_and_is_a_warning) {
    const auto with_pit = [&](double pit) {
        return read_dem(write({.value =
                                   [pit](int column, int row, int) {
                                       return column < 5 && row < 4 ? pit : 1500.0 + 10 * column + 5 * row;
                                   }}),
                        GridChoice::kOwn)
            .value()
            .warnings;
    };
    for (const double pit : {-99.0, 0.0, -4500.0, 4000.0, 1.0}) {
        const auto warnings = with_pit(pit);
        ASSERT_EQ(warnings.size(), 1u) << pit;
        EXPECT_NE(warnings[0].find("stated.tif: row "), std::string::npos) << warnings[0];
    }
    // A wall of 120 m on 10 m is one that mountains have.
    EXPECT_TRUE(with_pit(1420).empty());
}

TEST_F(RasterStates, its_system_in_a_prj_of_any_kind) {
    const auto read = [&](const std::string& prj) {
        const auto path = test::write_ascii_grid(
            folder_.path(), "placed", {.west = kWest, .south = kNorth - 300, .prj = prj},
            [](double x, double y) { return 800 + 0.1 * (x - kWest) + 0.1 * (y - kNorth); });
        return read_dem(path, 8);
    };
    const GdalErrors registered;
    OGRSpatialReferenceH system = OSRNewSpatialReference(nullptr);
    ASSERT_EQ(OSRImportFromEPSG(system, 32632), OGRERR_NONE);
    char* text = nullptr;
    const std::array<const char*, 2> options{"FORMAT=WKT2_2019", nullptr};
    ASSERT_EQ(OSRExportToWktEx(system, &text, options.data()), OGRERR_NONE);
    const std::string wkt2 = text;
    CPLFree(text);
    OSRDestroySpatialReference(system);
    for (const std::string& prj :
         {test::utm_32n(), wkt2, std::string("EPSG:32632"), std::string("epsg:32632\r\n"),
          std::string("32632"), "\xEF\xBB\xBF" + test::utm_32n(), "\xEF\xBB\xBF" + wkt2}) {
        const auto terrain = read(prj);
        ASSERT_TRUE(terrain) << prj << terrain.error();
        EXPECT_TRUE(terrain->georeference.placed()) << prj;
    }
    for (const char* prj :
         {"UTM zone 32", "PROJCS[\"cut\",GEOGCS[", "EPSG:999999", "https://epsg.io/32632", "{}"}) {
        const auto terrain = read(prj);
        ASSERT_FALSE(terrain) << prj;
        EXPECT_NE(terrain.error().find("placed.prj"), std::string::npos) << terrain.error();
    }
    // Also of a format whose .prj GDAL does not read.
    const auto points = folder_.path() / "points.xyz";
    std::string text_of_points;
    for (int i = 0; i < 100; ++i)
        text_of_points +=
            std::to_string(683'000 + i % 10 * 10) + " " + std::to_string(5'240'090 - i / 10 * 10) + " 500\n";
    test::write_text(points, text_of_points);
    EXPECT_FALSE(read_dem(points, 8).value().georeference.placed());
    test::write_text(folder_.path() / "points.prj", wkt2);
    EXPECT_TRUE(read_dem(points, 8).value().georeference.placed());
}

TEST_F(RasterStates, a_system_given_by_code_or_text) {
    const auto give = [&](const std::string& text) {
        auto terrain =
            read_dem(test::write_ascii_grid(folder_.path(), "bare", {.west = kWest, .south = kNorth - 300},
                                            [](double, double) { return 500.0; }),
                     8)
                .value();
        return set_system(text, terrain).has_value();
    };
    for (const char* text : {"EPSG:32632", "epsg:32632", "EPSG:32632+5773", "32632"})
        EXPECT_TRUE(give(text)) << text;
    for (const char* text :
         {"EPSG:32632+6360", "EPSG:32632+", "EPSG:4326", "EPSG:", "EPSG:3263x", "EPSG:99999", ""})
        EXPECT_FALSE(give(text)) << text;
}

// GDAL's pixels and OpenImageIO's channels are read in one source each.
TEST(Rasters, are_read_in_one_place) {
    for (const auto& entry : fs::recursive_directory_iterator(support::source_dir() / "terrains")) {
        if (!entry.is_regular_file()) continue;
        std::ifstream file(entry.path());
        const std::string text((std::istreambuf_iterator<char>(file)), {});
        const std::string name = entry.path().filename().string();
        for (const char* call : {"GF_Read", "GDALDatasetRasterIO", "GDALReadBlock", "ComputeRasterMinMax"})
            EXPECT_TRUE(name == "raster_values.cpp" || text.find(call) == std::string::npos)
                << name << ": " << call;
        EXPECT_TRUE(name == "grey_picture.cpp" || text.find("read_image(") == std::string::npos) << name;
    }
}

}  // namespace
}  // namespace terrains
