// Words of text rasters: each is one number to its end, or it is no data, or the file is refused; in every format and
// for every use.
#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "terrains/dem_gdal.h"
#include "terrains/release.h"
#include "tests/support/places.h"
#include "tests/terrains/files.h"

namespace terrains {
namespace {

constexpr int kColumns = 12, kRows = 10;

// A text raster of kColumns × kRows points, 10 m apart, of 1 m each, but for one word.
struct TextFormat {
    const char* name;
    bool words_are_void;  // "NA" is no data
    std::function<std::string(int at, const std::string& word)> text;
};

std::string values(int at, const std::string& word, const char* usual) {
    std::string text;
    for (int i = 0; i < kColumns * kRows; ++i)
        text += (i == at ? word : usual) + ((i + 1) % kColumns == 0 ? std::string("\n") : std::string(" "));
    return text;
}

const std::vector<TextFormat>& text_formats() {
    static const std::vector<TextFormat> kAll{
        {"hill.asc", true,
         [](int at, const std::string& word) {
             return fmt::format("ncols {}\nnrows {}\nxllcenter 0\nyllcenter 0\ncellsize 10\n{}", kColumns,
                                kRows, values(at, word, "1.50"));
         }},
        {"grass.txt", true,
         [](int at, const std::string& word) {
             return fmt::format("north: 95\nsouth: -5\neast: 115\nwest: -5\nrows: {}\ncols: {}\n{}", kRows,
                                kColumns, values(at, word, "1.50"));
         }},
        {"surfer.grd", false,
         [](int at, const std::string& word) {
             return fmt::format("DSAA\n{} {}\n0 110\n0 90\n1 2\n{}", kColumns, kRows,
                                values(at, word, "1.50"));
         }},
        {"points.xyz", false,
         [](int at, const std::string& word) {
             std::string text;
             for (int i = 0; i < kColumns * kRows; ++i)
                 text += fmt::format("{} {} {}\n", i % kColumns * 10, 90 - i / kColumns * 10,
                                     i == at ? word : "1.50");
             return text;
         }},
    };
    return kAll;
}

class RasterText : public testing::Test {
  protected:
    // What each use says of the file: "" if it is read.
    std::array<std::string, 3> uses(const TextFormat& format, const std::string& text) {
        const auto path = folder_.path() / format.name;
        test::write_text(path, text);
        const auto said = [](const auto& read) { return read ? std::string() : read.error(); };
        return {said(read_dem(path, 8)), said(read_release(path, ground_)),
                said(read_reference(path, ground_))};
    }

    support::TemporaryFolder folder_;
    Terrain ground_ =
        read_dem(test::write_ascii_grid(folder_.path(), "ground", {.columns = kColumns, .rows = kRows},
                                        [](double, double) { return 500.0; }),
                 8)
            .value();
};

TEST_F(RasterText, is_read_in_every_format_if_all_words_are_numbers) {
    for (const TextFormat& format : text_formats())
        for (const char* word : {"1.5", "+1.5", "15e-1", "1.", ".5", "2"})
            for (const std::string& error : uses(format, format.text(40, word)))
                EXPECT_EQ(error, "") << format.name << " " << word;
}

TEST_F(RasterText, is_refused_with_row_and_column_if_a_word_is_no_number) {
    for (const TextFormat& format : text_formats())
        for (const char* word : {"1'588.00", "1,588.00", "15O0.25", "1.5m", "########", "****", "0x1F", "1_5",
                                 "abc", "1.5.2", "--5", "1e"})
            for (const std::string& error : uses(format, format.text(40, word))) {
                EXPECT_NE(error, "") << format.name << " " << word;
                if (format.words_are_void) {
                    EXPECT_NE(error.find("row 4, column 5 is '"), std::string::npos) << error;
                }
            }
}

TEST_F(RasterText, takes_the_usual_words_for_no_data_or_refuses_them) {
    for (const TextFormat& format : text_formats())
        for (const char* word : {"NA", "*", "null", "NODATA", "-", "nan", "N/A"}) {
            const auto path = folder_.path() / format.name;
            test::write_text(path, format.text(40, word));
            const auto terrain = read_dem(path, GridChoice::kOwn);
            // GDAL takes "null" in GRASS ASCII for a key.
            const bool may_be_refused = !format.words_are_void || (word == std::string("null") &&
                                                                   format.name == std::string("grass.txt"));
            ASSERT_TRUE(may_be_refused || terrain) << format.name << " " << word << terrain.error();
            if (!terrain) continue;
            // Rows of Surfer come from the south.
            const int row = 40 / kColumns,
                      from_south = format.name == std::string("surfer.grd") ? row : kRows - 1 - row;
            const auto vertex = static_cast<std::size_t>(from_south * kColumns + 40 % kColumns);
            EXPECT_EQ(terrain->has_data[vertex], 0) << format.name << " " << word;
            EXPECT_EQ(terrain->has_data[vertex + 1], 1) << format.name << " " << word;
            const auto thickness = test::thickness_in(path, *terrain);
            ASSERT_TRUE(thickness) << thickness.error();
            EXPECT_EQ((*thickness)[vertex], 0.f);
        }
}

TEST_F(RasterText, has_as_many_numbers_as_its_header_promises) {
    for (const TextFormat& format : text_formats())
        for (const char* words : {"1.5 1.5", ""})
            for (const std::string& error : uses(format, format.text(40, words)))
                EXPECT_NE(error, "") << format.name << " '" << words << "'";
}

TEST_F(RasterText, has_decimal_commas_throughout_or_not_at_all) {
    const TextFormat& ascii = text_formats().front();
    const std::string points = ascii.text(0, "1.50");
    std::string commas = points;
    for (char& c : commas)
        if (c == '.') c = ',';
    for (const std::string& error : uses(ascii, commas)) EXPECT_EQ(error, "");
    for (const std::string& error : uses(ascii, ascii.text(40, "1,5")))
        EXPECT_NE(error.find("comma"), std::string::npos) << error;
    // All of it may be thousands.
    std::string thousands = commas;
    for (std::size_t at = 0; (at = thousands.find("1,50", at)) != std::string::npos; at += 5)
        thousands.replace(at, 4, "1,500");
    for (const std::string& error : uses(ascii, thousands))
        EXPECT_NE(error.find("thousands"), std::string::npos) << error;
}

TEST_F(RasterText, has_a_header_of_numbers) {
    const TextFormat &ascii = text_formats()[0], &grass = text_formats()[1];
    const auto with = [](std::string text, const std::string& from, const std::string& to) {
        return text.replace(text.find(from), from.size(), to);
    };
    for (const std::string& error : uses(ascii, with(ascii.text(0, "1.5"), "cellsize 10", "cellsize 1O")))
        EXPECT_NE(error, "");
    for (const std::string& error : uses(ascii, with(ascii.text(0, "1.5"), "xllcenter", "xllcorner")))
        EXPECT_NE(error.find("corner along one axis"), std::string::npos) << error;
    for (const std::string& error : uses(grass, with(grass.text(0, "1.5"), "north: 95", "north: 47:30:00N")))
        EXPECT_NE(error, "");
    for (const std::string& error :
         uses(grass, with(grass.text(0, "1.5"), "cols: 12", "cols: 12\nmultiplier: 0.1")))
        EXPECT_NE(error.find("multiplied"), std::string::npos) << error;
}

TEST_F(RasterText, has_numbers_in_columns_of_points_that_began_with_them) {
    const TextFormat& points = text_formats()[3];
    std::string commas = "x,y,z,kind\n", semicolons = "X;Y;Z\n", spaces;
    for (int i = 0; i < kColumns * kRows; ++i) {
        commas += fmt::format("{},{},1.5,ground\n", i % kColumns * 10, 90 - i / kColumns * 10);
        semicolons += fmt::format("{};{};1,5\n", i % kColumns * 10, 90 - i / kColumns * 10);
        spaces += fmt::format("{}, {}, 1.5\r\n", i % kColumns * 10, 90 - i / kColumns * 10);
    }
    for (const std::string& text : {commas, semicolons, spaces})
        for (const std::string& error : uses(points, text)) EXPECT_EQ(error, "") << text.substr(0, 40);
    const auto spoilt = [](std::string text, const std::string& word) {
        return text.replace(text.find("1.5", text.size() / 2), 3, word);
    };
    for (const char* word : {"NA", "1'5", "1,588.00", "*"})
        for (const std::string& error : uses(points, spoilt(commas, word))) EXPECT_NE(error, "") << word;
}

}  // namespace
}  // namespace terrains
