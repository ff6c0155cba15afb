#include "render/view/screen_tiles.h"

#include <random>

#include <gtest/gtest.h>

namespace render::test {
namespace {

constexpr int kFrameWidth = 133, kFrameHeight = 77;

struct Marked {
    ScreenTiles tiles;
    std::vector<int> wanted = std::vector<int>(kFrameWidth * kFrameHeight);

    explicit Marked(int tile) { tiles.begin(kFrameWidth, kFrameHeight, tile); }
    void mark(const Rectangle& r) {
        tiles.mark(r);
        for (int y = std::max(r.bottom, 0); y < std::min(r.top, kFrameHeight); ++y)
            for (int x = std::max(r.left, 0); x < std::min(r.right, kFrameWidth); ++x)
                wanted[static_cast<std::size_t>(y * kFrameWidth + x)] = 1;
    }
    // Samples of all rectangles. Each of the frame is in one of them at most, and in one if it was marked.
    int expect_covered(int most, int least_gain) {
        std::vector<int> covered(wanted.size());
        const auto rectangles = tiles.rectangles(most, least_gain);
        EXPECT_LE(rectangles.size(), static_cast<std::size_t>(most));
        int samples = 0;
        for (const Rectangle& r : rectangles) {
            EXPECT_TRUE(r.left >= 0 && r.bottom >= 0 && r.right <= kFrameWidth && r.top <= kFrameHeight);
            samples += r.width() * r.height();
            for (int y = r.bottom; y < r.top; ++y)
                for (int x = r.left; x < r.right; ++x)
                    ++covered[static_cast<std::size_t>(y * kFrameWidth + x)];
        }
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            EXPECT_LE(covered[i], 1) << "sample " << i;
            EXPECT_GE(covered[i], wanted[i]) << "sample " << i;
        }
        return samples;
    }
};

TEST(ScreenTiles, cover_every_mark_once_whatever_is_marked) {
    std::mt19937 random(7);
    const auto from = [&](int low, int high) {
        return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
    };
    for (int round = 0; round < 300; ++round) {
        Marked marked(from(1, 40));
        for (int i = from(0, 12); i > 0; --i) {
            const int x = from(-30, kFrameWidth + 10), y = from(-30, kFrameHeight + 10);
            marked.mark({x, y, x + from(-1, 60), y + from(-1, 60)});
        }
        marked.expect_covered(from(1, 20), from(0, 2000));
    }
}

TEST(ScreenTiles, with_room_for_one_rectangle_are_the_box_around_all_marks) {
    Marked marked(1);
    marked.mark({3, 4, 10, 9});
    marked.mark({50, 40, 51, 41});
    EXPECT_EQ(marked.expect_covered(1, 0), 48 * 37);
    EXPECT_EQ(marked.expect_covered(2, 0), 7 * 5 + 1);
    EXPECT_EQ(marked.expect_covered(2, 48 * 37), 48 * 37);  // not worth a second rectangle
}

TEST(ScreenTiles, find_marks_that_lie_in_an_L_in_two_rectangles) {
    Marked marked(1);
    marked.mark({10, 10, 20, 70});
    marked.mark({10, 10, 90, 20});
    EXPECT_EQ(marked.expect_covered(8, 0), 10 * 60 + 70 * 10);
}

TEST(ScreenTiles, forget_their_marks_when_they_begin_again) {
    Marked marked(8);
    marked.mark({3, 4, 100, 60});
    EXPECT_TRUE(marked.tiles.any());
    marked.tiles.begin(kFrameWidth, kFrameHeight, 8);
    EXPECT_FALSE(marked.tiles.any());
    EXPECT_TRUE(marked.tiles.rectangles(8, 0).empty());
    marked.tiles.mark_all();
    ASSERT_EQ(marked.tiles.rectangles(8, 0).size(), 1u);
    EXPECT_EQ(marked.tiles.rectangles(8, 0)[0], (Rectangle{0, 0, kFrameWidth, kFrameHeight}));
}

}  // namespace
}  // namespace render::test
