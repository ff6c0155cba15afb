#include <algorithm>
#include <cstdint>
#include <filesystem>

#include <gtest/gtest.h>

#include "game/app/slide_map.h"
#include "render/pictures/png.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

// Shares of pixels in a part of a page, px from the top left, that are white and that have a colour of top speeds.
struct PartOfPage {
    double white = 0, speed = 0;
};

PartOfPage look_at(const render::Texels& page, int x0, int y0, int x1, int y1) {
    PartOfPage part;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            // Texels begin with the lowest row.
            const std::uint8_t* const at =
                &page.values[static_cast<std::size_t>(3 * ((page.height - 1 - y) * page.width + x))];
            part.white += at[0] == 255 && at[1] == 255 && at[2] == 255;
            const glm::vec3 colour(at[0], at[1], at[2]);
            part.speed += std::ranges::find(speed_colours(), colour) != speed_colours().end();
        }
    const double all = (x1 - x0) * (y1 - y0);
    return {part.white / all, part.speed / all};
}

TEST(Poster, is_a_page_with_a_picture_a_map_and_numbers) {
    const support::TemporaryFolder folder;
    const auto file = folder.path() / "slide.png";
    const Finished done = couloir({"replay", "landslide", "--until", "300", "--poster", file.string()});
    ASSERT_EQ(done.status, 0) << done.err;
    const auto page = render::read_png(file, 3);
    ASSERT_TRUE(page) << page.error();
    EXPECT_EQ(page->width, 2480);
    EXPECT_EQ(page->height, 1754);
    EXPECT_EQ(look_at(*page, 0, 0, 2480, 60).white, 1) << "a margin";
    EXPECT_LT(look_at(*page, 90, 66, 600, 134).white, 1) << "the title";
    EXPECT_LT(look_at(*page, 90, 220, 1670, 1280).white, 0.5) << "the picture";
    EXPECT_LT(look_at(*page, 1730, 220, 2000, 500).white, 0.5) << "the map";
    EXPECT_GT(look_at(*page, 1730, 600, 2390, 1300).speed, 0.02) << "its key";
    const double rows = look_at(*page, 90, 1390, 2390, 1500).white;
    EXPECT_TRUE(0.5 < rows && rows < 1) << "the numbers: " << rows;
}

TEST(Poster, is_refused_in_a_sentence_where_it_cannot_be) {
    const support::TemporaryFolder folder;
    const Finished nowhere = couloir({"replay", "landslide", "--until", "6", "--poster", "/proc/none/a.png"});
    EXPECT_EQ(nowhere.status, 3);
    EXPECT_NE(nowhere.err.find("/proc/none"), std::string::npos) << nowhere.err;
    const auto mine = folder.path() / "mine.couloir";
    write_bytes(mine, read_bytes(support::source_dir() / "assets/recordings/landslide.couloir"));
    EXPECT_EQ(couloir({"replay", mine.string(), "--poster", mine.string()}).status, 2);
    EXPECT_EQ(couloir({"replay", "landslide", "--until", "6", "--no-render", "--poster",
                       (folder.path() / "none.png").string()})
                  .status,
              0);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "none.png"));
}

}  // namespace
}  // namespace game::test
