#include "game/controls/photo.h"

#include <gtest/gtest.h>

#include "game/controls/photo_parts.h"
#include "render/view/sky_light.h"

namespace game::test {
namespace {

TEST(Photo, has_the_focal_lengths_of_a_sensor_36_mm_wide) {
    EXPECT_NEAR(field_of_view_of(18, 1), 90, 1e-9);
    for (const double aspect : {0.5, 1.0, 16.0 / 9, 3.5}) {
        const FocalLengths focal = focal_lengths(aspect);
        EXPECT_LT(focal.least, focal.most);
        for (const double mm : {focal.least, 35.0, focal.most})
            EXPECT_NEAR(focal_length_of(field_of_view_of(mm, aspect), aspect), mm, 1e-9);
        EXPECT_LE(field_of_view_of(focal.least, aspect), 120 + 1e-9);
        EXPECT_GE(field_of_view_of(focal.most, aspect), 5 - 1e-9);
    }
}

TEST(Photo, is_blurred_as_by_a_thin_lens_before_a_model) {
    PhotoSettings settings{.focal_mm = 50};
    EXPECT_EQ(blur_of(settings, 1000, 1.5), 0) << "all is sharp";
    settings.f_number = 2.8;
    // 50 mm at f/2.8, focused at 2 m: a circle of 0.458 mm on a sensor 24 mm high.
    EXPECT_NEAR(blur_of(settings, 2 * kModelScale, 1.5), 0.458 / 2 / 24, 1e-5);
    settings.f_number = 5.6;
    EXPECT_NEAR(blur_of(settings, 2 * kModelScale, 1.5), 0.458 / 4 / 24, 1e-5);
    EXPECT_LT(blur_of(settings, 1, 1.5), 1) << "nearer than the lens can be focused";
    for (std::size_t i = 2; i < kFNumbers.size(); ++i) EXPECT_LT(kFNumbers[i], kFNumbers[i - 1]);
}

TEST(Photo, has_a_sun_that_rises_in_the_east_and_culminates_in_the_south_at_noon) {
    const PhotoDay day;
    const render::Light noon = light_at(12, day);
    EXPECT_NEAR(noon.azimuth_deg, 180, 1e-9);
    EXPECT_NEAR(noon.elevation_deg, 90 - day.latitude_deg + day.declination_deg, 1e-9);
    const render::Light morning = light_at(9, day), evening = light_at(15, day);
    EXPECT_LT(morning.azimuth_deg, 150);
    EXPECT_NEAR(morning.azimuth_deg + evening.azimuth_deg, 360, 1e-9);
    EXPECT_NEAR(morning.elevation_deg, evening.elevation_deg, 1e-9);
    EXPECT_EQ(light_at(0, day).elevation_deg, render::kLowestSunDeg);
    const render::Light south = light_at(12, {-33, 13});
    EXPECT_NEAR(std::remainder(south.azimuth_deg, 360), 0, 1e-6) << "it stands in the north there";
    for (double hour = 6; hour <= 18; hour += 0.25) EXPECT_EQ(hour_like(light_at(hour, day), day), hour);
}

TEST(Photo, is_drawn_in_as_few_parts_as_fit_the_device_and_its_memory) {
    const ScreenSize screen{1281, 719, 1};
    const int rim = render::kPartOverlap;
    for (const int times : {2, 4}) {
        const auto plan = PhotoParts::plan(screen, times, rim, {});
        ASSERT_TRUE(plan);
        EXPECT_EQ(plan->parts(), times * times);
        EXPECT_EQ(plan->width(), times * screen.width);
        EXPECT_LE(plan->frame().width, screen.width + 3 * rim);
    }
    const ImageBounds small{1024, bytes_of({300, 300, true})};
    const auto plan = PhotoParts::plan(screen, 2, rim, small);
    ASSERT_TRUE(plan);
    EXPECT_GT(plan->parts(), 4);
    EXPECT_LE(2 * std::max(plan->frame().width, plan->frame().height), small.longest_side);
    EXPECT_LE(bytes_of(plan->frame()), small.most_bytes);
    EXPECT_FALSE(PhotoParts::plan(screen, 2, rim, {64, UINT64_MAX}));
    EXPECT_FALSE(PhotoParts::plan(screen, 2, rim, {16384, 1000}));
}

TEST(Photo, has_every_pixel_from_the_part_that_shows_it) {
    const auto plan = PhotoParts::plan({50, 30, 1}, 3, render::kPartOverlap, {});
    ASSERT_TRUE(plan);
    render::Picture photo{
        plan->width(), plan->height(),
        std::vector<std::uint8_t>(static_cast<std::size_t>(3 * plan->width() * plan->height()))};
    // Red is the column of the photo, green its row from below.
    for (int part = 0; part < plan->parts(); ++part) {
        const render::WholeImage place = plan->place(part);
        EXPECT_EQ(place.left % render::kPartOverlap, 0);
        EXPECT_EQ(place.bottom % render::kPartOverlap, 0);
        const ImageSize size = plan->frame();
        render::Picture frame{size.width, size.height, {}};
        for (int y = size.height - 1; y >= 0; --y)
            for (int x = 0; x < size.width; ++x)
                for (const int value : {place.left + x, place.bottom + y, 1})
                    frame.pixels.push_back(static_cast<std::uint8_t>(value));
        plan->put(part, frame, photo);
    }
    for (int y = 0; y < photo.height; ++y)
        for (int x = 0; x < photo.width; ++x) {
            const auto at = static_cast<std::size_t>(3 * ((photo.height - 1 - y) * photo.width + x));
            ASSERT_EQ(photo.pixels[at], x);
            ASSERT_EQ(photo.pixels[at + 1], y);
            ASSERT_EQ(photo.pixels[at + 2], 1);
        }
}

}  // namespace
}  // namespace game::test
