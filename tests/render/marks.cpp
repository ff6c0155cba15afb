#include "render/frame/marks.h"

#include <cmath>

#include <gtest/gtest.h>

namespace render {
namespace {

TEST(ContourInterval, is_one_two_or_five_of_a_power_of_ten_with_16_to_40_lines_over_the_terrain) {
    for (float range = 45; range < 5000; range *= 1.07f) {
        const double interval = contour_interval({-200, range - 200});
        const double digit = interval / std::pow(10, std::floor(std::log10(interval) + 1e-9));
        EXPECT_TRUE(std::abs(digit - 1) < 1e-9 || std::abs(digit - 2) < 1e-9 || std::abs(digit - 5) < 1e-9)
            << range << ": " << interval;
        EXPECT_LE(range / interval, 40.01) << range;
        EXPECT_GE(range / interval, 15.9) << range;
    }
}

TEST(ContourInterval, is_never_below_a_metre) {
    EXPECT_EQ(contour_interval({3, 3}), 1);
    EXPECT_EQ(contour_interval({0, 12}), 1);
}

class Legends : public testing::TestWithParam<Overlay> {};

TEST_P(Legends, rise_from_stop_to_stop_in_colours_that_a_screen_has) {
    const Legend legend = legend_of(GetParam());
    ASSERT_GE(legend.stops.size(), 2u);
    for (std::size_t i = 0; i < legend.stops.size(); ++i) {
        if (i > 0) {
            EXPECT_GT(legend.stops[i].value, legend.stops[i - 1].value);
        }
        for (int c = 0; c < 3; ++c) {
            EXPECT_GE(legend.stops[i].colour[c], 0);
            EXPECT_LE(legend.stops[i].colour[c], 1);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Of, Legends,
                         testing::Values(Overlay::kSlope, Overlay::kStanding, Overlay::kRolling,
                                         Overlay::kSpeed, Overlay::kPressure, Overlay::kProbability,
                                         Overlay::kWater));

TEST(Legends, of_no_overlay_has_no_stops) {
    EXPECT_TRUE(legend_of(Overlay::kNone).stops.empty());
}

}  // namespace
}  // namespace render
