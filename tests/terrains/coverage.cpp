#include "terrains/coverage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace terrains {
namespace {

const sim::Grid kGrid{12, 10, 10.f};

Area box(double west, double south, double east, double north, double thickness) {
    return {{{{west, south}, {east, south}, {east, north}, {west, north}, {west, south}}}, thickness};
}

double volume(const sim::Grid& grid, const std::vector<float>& thickness) {
    return std::accumulate(thickness.begin(), thickness.end(), 0.0) * grid.cell_area();
}

TEST(Coverage, gives_whole_cells_their_whole_thickness) {
    const auto mean = cover(kGrid, {box(15, 25, 45, 35, 2)}).value().mean;
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 12; ++x)
            EXPECT_EQ(mean[y * 12 + x], y == 3 && x >= 2 && x <= 4 ? 2.f : 0.f) << x << ", " << y;
}

TEST(Coverage, gives_a_cell_covered_by_half_half_the_thickness) {
    const auto mean = cover(kGrid, {box(20, 25, 45, 30, 2)}).value().mean;
    EXPECT_EQ(mean[3 * 12 + 2], 0.5f);  // a quarter
    EXPECT_EQ(mean[3 * 12 + 3], 1.f);
}

TEST(Coverage, leaves_holes_empty) {
    Area ring = box(5, 5, 65, 65, 1);
    ring.rings.push_back(box(25, 25, 45, 45, 1).rings[0]);
    const auto mean = cover(kGrid, {ring}).value().mean;
    EXPECT_EQ(mean[3 * 12 + 3], 0.f);
    EXPECT_NEAR(volume(kGrid, mean), 60 * 60 - 20 * 20, 1e-6);
}

TEST(Coverage, counts_the_thickest_where_areas_overlap) {
    const auto mean =
        cover(kGrid, {box(15, 15, 45, 45, 1), box(25, 25, 55, 55, 3), box(25, 25, 35, 35, 2)}).value().mean;
    EXPECT_EQ(mean[2 * 12 + 2], 1.f);
    EXPECT_EQ(mean[3 * 12 + 3], 3.f);
}

TEST(Coverage, cuts_areas_at_the_grid) {
    const auto mean = cover(kGrid, {box(-1e7, -1e7, 1e7, 1e7, 1)}).value().mean;
    for (const float m : mean) EXPECT_EQ(m, 1.f);
    const auto away = cover(kGrid, {box(500, 500, 600, 600, 1)}).value().mean;
    EXPECT_EQ(volume(kGrid, away), 0);
}

TEST(Coverage, conserves_the_volume_of_a_rotated_square_to_half_a_per_cent) {
    Area turned{{{}}, 1};
    for (int corner = 0; corner <= 4; ++corner) {
        const double angle = 0.4 + corner * 3.14159265358979 / 2;
        turned.rings[0].push_back({52 + 30 * std::cos(angle), 47 + 30 * std::sin(angle)});
    }
    EXPECT_NEAR(volume(kGrid, cover(kGrid, {turned}).value().mean), 2 * 30 * 30, 0.005 * 1800);
}

TEST(Coverage, refuses_outlines_that_would_take_too_long) {
    Area saw{{{}}, 1};
    for (int tooth = 0; tooth < 100'000; ++tooth) {
        saw.rings[0].push_back({tooth * 1e-3, 0});
        saw.rings[0].push_back({tooth * 1e-3, 90});
    }
    EXPECT_FALSE(cover(kGrid, {saw, saw}));
}

}  // namespace
}  // namespace terrains
