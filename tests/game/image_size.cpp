#include "game/controls/image_size.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace game::test {
namespace {

TEST(ImageSize, is_that_of_the_screen_times_the_scale) {
    EXPECT_EQ(image_for({1280, 720}, 1, true, {}), (ImageSize{1280, 720, true}));
    EXPECT_EQ(image_for({1280, 720}, 0.375, false, {}), (ImageSize{480, 270, false}));
    EXPECT_EQ(image_for({801, 433}, 0.5, false, {}), (ImageSize{401, 217, false}));
}

TEST(ImageSize, has_640_by_360_pixels_at_least_and_1280_by_720_before_a_camera_that_stands) {
    EXPECT_EQ(least_scale(Tier::kFast, {1280, 720}, true), 0.5);
    EXPECT_EQ(least_scale(Tier::kFast, {1280, 720}, false), 1);
    EXPECT_EQ(least_scale(Tier::kFast, {2560, 1440}, false), 0.5);
    EXPECT_EQ(least_scale(Tier::kBalanced, {1280, 720}, true), 0.75);
    EXPECT_EQ(least_scale(Tier::kBalanced, {2560, 1440}, false), 0.75);
    EXPECT_EQ(least_scale(Tier::kFast, {640, 360}, true), 1);
    EXPECT_EQ(least_scale(Tier::kFast, {1, 1}, true), 1);
    EXPECT_EQ(least_scale(Tier::kFast, {7680, 4320}, true), 0.25);
}

TEST(ImageSize, is_a_pixel_at_least) {
    EXPECT_EQ(image_for({1, 1}, 0.25, false, {}), (ImageSize{1, 1, false}));
    EXPECT_EQ(image_for({8000, 1}, 0.25, true, {.longest_side = 1000}), (ImageSize{1000, 1, false}));
    EXPECT_EQ(image_for({1, 1}, 1, true, {.longest_side = 1, .most_bytes = 1}), (ImageSize{1, 1, false}));
}

TEST(ImageSize, has_one_sample_per_pixel_before_it_has_fewer_pixels) {
    const ImageBounds bounds{.longest_side = 8000};
    EXPECT_EQ(image_for({4000, 4000}, 1, true, bounds), (ImageSize{4000, 4000, true}));
    EXPECT_EQ(image_for({8000, 8000}, 1, true, bounds), (ImageSize{8000, 8000, false}));
    EXPECT_EQ(image_for({16000, 8000}, 1, true, bounds), (ImageSize{8000, 4000, false}));
}

TEST(ImageSize, never_exceeds_its_bounds) {
    for (const ScreenSize screen : {ScreenSize{1, 1}, {1023, 7}, {1280, 720}, {8000, 8000}, {32767, 32767}})
        for (const double scale : {0.25, 0.375, 1.})
            for (const bool fine : {false, true})
                for (const ImageBounds bounds :
                     {ImageBounds{16384}, ImageBounds{511}, ImageBounds{16384, 100'000'000},
                      ImageBounds{2048, 1'000'000}}) {
                    const ImageSize image = image_for(screen, scale, fine, bounds);
                    EXPECT_LE(std::max(image.width, image.height) * (image.fine ? 2 : 1),
                              bounds.longest_side);
                    EXPECT_LE(bytes_of(image), std::max(bounds.most_bytes, bytes_of({1, 1, false})));
                    EXPECT_LE(image.width, screen.width);
                    EXPECT_LE(image.height, screen.height);
                }
}

}  // namespace
}  // namespace game::test
