#include "terrains/heightmap_image.h"

#include <array>
#include <string>

#include <gdal.h>
#include <gtest/gtest.h>

#include "terrains/gdal_support.h"
#include "tests/support/places.h"
#include "tests/terrains/files.h"
#include "tests/terrains/memory_files.h"

namespace terrains {
namespace {

// A grey PGM of 16 or 8 bits; value(column, row), row 0 the north.
template <class Value>
std::string pgm(int columns, int rows, int white, Value value) {
    std::string text =
        "P5\n" + std::to_string(columns) + " " + std::to_string(rows) + "\n" + std::to_string(white) + "\n";
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int v = value(column, row);
            if (white > 255) text += static_cast<char>(v >> 8);
            text += static_cast<char>(v & 0xff);
        }
    return text;
}

constexpr HeightmapScale kScale{.cell = 5, .lowest = 1000, .highest = 1000 + 65535 / 32.0};

TEST(Heightmap, reproduces_a_plane_of_sixteen_bits_exactly) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "hill.pgm";
    test::write_text(path,
                     pgm(41, 33, 65535, [](int column, int row) { return 100 + 33 * column + 7 * row; }));
    for (const int squares : {16, 40, 80}) {
        const auto terrain = read_heightmap(path, kScale, squares);
        ASSERT_TRUE(terrain) << terrain.error();
        EXPECT_EQ(terrain->name, "hill.pgm");
        EXPECT_FALSE(terrain->georeference.placed());
        for (int y = 0; y < terrain->grid.ny; ++y)
            for (int x = 0; x < terrain->grid.nx; ++x) {
                const double column = x * static_cast<double>(terrain->grid.dx) / 5;
                const double row = 32 - y * static_cast<double>(terrain->grid.dx) / 5;
                ASSERT_NEAR(terrain->surface[static_cast<std::size_t>(y) * terrain->grid.nx + x],
                            1000 + (100 + 33 * column + 7 * row) / 32, 1e-3);
            }
    }
}

TEST(Heightmap, keeps_the_single_steps_of_sixteen_bits) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "hill.pgm";
    test::write_text(path, pgm(41, 33, 65535, [](int column, int) { return 30'000 + column; }));
    const auto terrain = read_heightmap(path, kScale, 40).value();
    for (int x = 0; x < 40; ++x) EXPECT_NEAR(terrain.surface[x + 1] - terrain.surface[x], 1 / 32.0, 2e-4);
}

TEST(Heightmap, maps_black_and_white_of_eight_bits_to_lowest_and_highest) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "hill.pgm";
    test::write_text(path, pgm(9, 9, 255, [](int, int row) { return row == 0 ? 255 : 0; }));
    const auto terrain = read_heightmap(path, {.cell = 10, .lowest = 200, .highest = 700}, 8).value();
    EXPECT_FLOAT_EQ(terrain.surface.front(), 200);  // south
    EXPECT_FLOAT_EQ(terrain.surface.back(), 700);   // north
}

// Grey and opacity by GDAL, as PNG or TIFF of 8 or 16 bits. Grey rises to the north-east; opacity is `opaque` of white,
// and 0 in the four columns of the west.
std::filesystem::path with_opacity(const std::filesystem::path& folder, const char* driver, GDALDataType type,
                                   const char* alpha, double opaque) {
    constexpr int kSide = 32;
    const GdalErrors registered;
    const double white = type == GDT_Byte ? 255 : 65535;
    const std::string option = std::string("ALPHA=") + alpha;
    std::array<char*, 2> options{const_cast<char*>(option.c_str()), nullptr};
    {
        const Dataset made(GDALCreate(GDALGetDriverByName("GTiff"), "/vsimem/grey/hill.tif", kSide, kSide, 2,
                                      type, options.data()));
        for (int row = 0; row < kSide; ++row)
            for (const int band : {1, 2}) {
                std::array<double, kSide> values{};
                for (int column = 0; column < kSide; ++column)
                    values[static_cast<std::size_t>(column)] =
                        band == 1    ? white * (column + kSide - 1 - row) / (2 * kSide)
                        : column < 4 ? 0
                                     : white * opaque;
                EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(made.get(), band), GF_Write, 0, row, kSide, 1,
                                       values.data(), kSide, 1, GDT_Float64, 0, 0),
                          CE_None);
            }
        if (std::string(driver) == "PNG")
            Dataset(GDALCreateCopy(GDALGetDriverByName("PNG"), "/vsimem/grey/hill.png", made.get(), FALSE,
                                   nullptr, nullptr, nullptr));
    }
    test::unload("/vsimem/grey", folder);
    return folder / (std::string(driver) == "PNG" ? "hill.png" : "hill.tif");
}

TEST(Heightmap, has_heights_that_no_opacity_changes_and_none_where_it_is_transparent) {
    const support::TemporaryFolder folder;
    const HeightmapScale scale{.cell = 10, .lowest = 0, .highest = 6400};
    for (const char* driver : {"PNG", "GTiff"})
        for (const GDALDataType type : {GDT_Byte, GDT_UInt16})
            for (const double opaque : {1.0, 0.5, 0.1}) {
                const auto path = with_opacity(folder.path(), driver, type, "NON-PREMULTIPLIED", opaque);
                const auto terrain = read_heightmap(path, scale, 31);
                ASSERT_TRUE(terrain) << terrain.error();
                const double step = type == GDT_Byte ? 6400 / 255.0 : 0.1;
                for (std::size_t y = 0; y < 32; ++y)
                    for (std::size_t x = 0; x < 32; ++x) {
                        EXPECT_EQ(terrain->has_data[y * 32 + x], x < 4 ? 0 : 1) << x;
                        if (x >= 4) {
                            EXPECT_NEAR(terrain->surface[y * 32 + x], 100.0 * static_cast<double>(x + y),
                                        step)
                                << driver << " " << opaque;
                        }
                    }
            }
}

TEST(Heightmap, is_refused_where_opacity_was_multiplied_into_its_grey) {
    const support::TemporaryFolder folder;
    const HeightmapScale scale{.cell = 10, .lowest = 0, .highest = 6400};
    EXPECT_TRUE(
        read_heightmap(with_opacity(folder.path(), "GTiff", GDT_Byte, "PREMULTIPLIED", 1), scale, 31));
    const auto half =
        read_heightmap(with_opacity(folder.path(), "GTiff", GDT_Byte, "PREMULTIPLIED", 0.5), scale, 31);
    ASSERT_FALSE(half);
    EXPECT_NE(half.error().find("row 1, column 5 is partly transparent"), std::string::npos) << half.error();
    EXPECT_FALSE(
        read_heightmap(with_opacity(folder.path(), "PNG", GDT_Byte, "NON-PREMULTIPLIED", 0), scale, 31));
}

TEST(Heightmap, errors_name_file_and_fact) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "bad.pgm";
    const std::string whole = pgm(20, 20, 65535, [](int column, int row) { return 50 * column + row; });
    const auto refusal = [&](const std::string& content, HeightmapScale scale = kScale, int squares = 10) {
        test::write_text(path, content);
        const auto terrain = read_heightmap(path, scale, squares);
        std::string said = terrain ? "it was read" : terrain.error();
        EXPECT_NE(said.find("bad.pgm: "), std::string::npos) << said;
        return said;
    };
    ASSERT_TRUE((test::write_text(path, whole), read_heightmap(path, kScale, 10)));
    EXPECT_NE(refusal("a letter").find("PNG"), std::string::npos);
    for (const std::size_t length : {whole.size() - 1, whole.size() / 2, std::size_t{30}})
        EXPECT_NE(refusal(whole.substr(0, length)).find("cut short"), std::string::npos) << length;
    EXPECT_NE(refusal(whole, {.cell = 0, .lowest = 0, .highest = 1}).find("pixel of 0 m"), std::string::npos);
    EXPECT_NE(refusal(whole, {.cell = 1, .lowest = 1, .highest = 1}).find("heights from 1 to 1"),
              std::string::npos);
    EXPECT_NE(refusal(whole, kScale, 7).find("8 to 4096"), std::string::npos);
    EXPECT_NE(refusal("P6\n2 2\n255\n" + std::string(12, 'a')).find("3 channels"), std::string::npos);
    EXPECT_FALSE(read_heightmap(folder.path() / "none.png", kScale, 10));
}

// Also if only some strips, tiles or rows of it are lost, which the library itself reads as black.
TEST(Heightmap, that_is_cut_short_anywhere_is_refused_or_is_the_whole_one) {
    constexpr int kSide = 32;
    const HeightmapScale scale{.cell = 10, .lowest = 0, .highest = 6400};
    const GdalErrors quiet;
    struct Kind {
        const char *driver, *name;
        std::vector<const char*> options;
    };
    for (const Kind& kind : {Kind{"GTiff", "strips.tif", {"BLOCKYSIZE=4"}},
                             Kind{"GTiff", "deflated.tif", {"BLOCKYSIZE=4", "COMPRESS=DEFLATE"}},
                             Kind{"GTiff", "tiles.tif", {"TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16"}},
                             Kind{"PNG", "hill.png", {}}}) {
        const support::TemporaryFolder folder;
        std::vector<unsigned char> grey(static_cast<std::size_t>(kSide) * kSide);
        for (std::size_t i = 0; i < grey.size(); ++i)
            grey[i] = static_cast<unsigned char>(40 + 3 * (i % kSide) + 2 * (i / kSide));
        {
            const Dataset source(GDALCreate(GDALGetDriverByName("GTiff"), "/vsimem/source.tif", kSide, kSide,
                                            1, GDT_Byte, nullptr));
            ASSERT_EQ(GDALRasterIO(GDALGetRasterBand(source.get(), 1), GF_Write, 0, 0, kSide, kSide,
                                   grey.data(), kSide, kSide, GDT_Byte, 0, 0),
                      CE_None);
            std::vector<char*> options;
            for (const char* option : kind.options) options.push_back(const_cast<char*>(option));
            options.push_back(nullptr);
            const Dataset made(GDALCreateCopy(GDALGetDriverByName(kind.driver),
                                              (std::string("/vsimem/cut/") + kind.name).c_str(), source.get(),
                                              FALSE, options.data(), nullptr, nullptr));
            ASSERT_TRUE(made) << kind.name;
        }
        test::unload("/vsimem/cut", folder.path());
        const auto path = folder.path() / kind.name;
        const auto whole = read_heightmap(path, scale, kSide - 1);
        ASSERT_TRUE(whole) << whole.error();
        const std::string bytes = test::read_text(path);
        int refused = 0;
        for (std::size_t length = bytes.size() - 1; length > 8; length -= std::min<std::size_t>(length, 7)) {
            test::write_text(path, bytes.substr(0, length));
            const auto cut = read_heightmap(path, scale, kSide - 1);
            if (cut) {
                EXPECT_EQ(cut->surface, whole->surface) << kind.name << " " << length;
            }
            refused += cut ? 0 : 1;
        }
        EXPECT_GT(refused, 5) << kind.name;
    }
}

// Whatever the library does with them, even if it throws.
TEST(Heightmap, refuses_files_that_only_begin_like_an_image) {
    const support::TemporaryFolder folder;
    using namespace std::string_literals;
    const std::string beginnings[]{"GIF87a",
                                   "GIF89a",
                                   "\x89PNG\r\n\x1a\n",
                                   "BM",
                                   "II*\0"s,
                                   "MM\0*"s,
                                   "\xff\xd8\xff\xe0",
                                   "P5\n",
                                   "P6\n",
                                   "Pf\n",
                                   "8BPS\0\1"s,
                                   "#?RADIANCE\n",
                                   "\x01\xda\0"s,
                                   "DDS |\0\0\0"s,
                                   "SDPX",
                                   "qoif",
                                   "\0\0\1\0"s,
                                   "RIFF\0\0\0\0WEBP"s,
                                   "\x76\x2f\x31\x01",
                                   "SIMPLE  =",
                                   "\0\0\0\x0cjP  \r\n\x87\n"s};
    for (const std::string& beginning : beginnings)
        for (const char fill : {'\0', '\xff', '1'})
            for (const std::size_t length : {0u, 1u, 7u, 20u, 100u}) {
                const auto path = folder.path() / "short.gif";
                test::write_text(path, beginning + std::string(length, fill));
                EXPECT_FALSE(read_heightmap(path, kScale, 10)) << beginning << " and " << length;
            }
}

}  // namespace
}  // namespace terrains
