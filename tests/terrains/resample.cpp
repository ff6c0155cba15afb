#include "terrains/resample.h"

#include <gtest/gtest.h>

#include <cmath>

namespace terrains {
namespace {

double plane(double x, double y) {
    return 1500 + 0.75 * x - 0.375 * y;
}

// A raster of 21 × 17 points, 10 m apart, over 200 m × 160 m.
template <class Height>
PlaneFit::Fitted fit_raster(const sim::Grid& grid, Height height) {
    constexpr double kSpacing = 10;
    const double reach = std::max<double>(grid.dx, kSpacing);
    PlaneFit fit(grid, reach, reach, kSpacing * kSpacing);
    for (int row = 0; row < 17; ++row)
        for (int column = 0; column < 21; ++column) {
            const double z = height(column, row);
            if (std::isnan(z))
                fit.add_void(column * kSpacing, row * kSpacing);
            else
                fit.add(column * kSpacing, row * kSpacing, z);
        }
    return fit.finish();
}

TEST(GridOver, puts_the_squares_along_the_longer_side_and_whole_ones_across) {
    const auto wide = grid_over(1000, 480, 20).value();
    EXPECT_EQ(wide.nx, 21);
    EXPECT_EQ(wide.ny, 10);  // 480 / 50 = 9.6 squares
    EXPECT_FLOAT_EQ(wide.dx, 50);
    const auto tall = grid_over(480, 1000, 20).value();
    EXPECT_EQ(tall.nx, 10);
    EXPECT_EQ(tall.ny, 21);
}

TEST(GridOver, keeps_a_square_square_and_inside_for_any_cell_size) {
    for (const double cell : {4.9977, 0.1, 28.5625, 1.0 / 3})
        for (const int squares : {8, 79, 160, 1001}) {
            const double side = cell * 417;
            const auto grid = grid_over(side, side, squares).value();
            EXPECT_EQ(grid.nx, grid.ny);
            EXPECT_LE(static_cast<double>(grid.dx) * squares, side);
            EXPECT_NEAR(static_cast<double>(grid.dx) * squares, side, side * 1e-6);
        }
}

TEST(GridOver, refuses_too_few_and_too_many_squares_and_a_strip) {
    EXPECT_FALSE(grid_over(100, 100, 7));
    EXPECT_FALSE(grid_over(100, 100, 4097));
    EXPECT_TRUE(grid_over(100, 100, 8));
    const auto strip = grid_over(1000, 10, 80);
    ASSERT_FALSE(strip);
    EXPECT_NE(strip.error().find("1000 m by 10 m"), std::string::npos) << strip.error();
}

TEST(PlaneFit, reproduces_a_plane_exactly_at_every_spacing) {
    for (const int squares : {8, 9, 20, 33, 64}) {
        const auto grid = grid_over(200, 160, squares).value();
        const auto fitted =
            fit_raster(grid, [](int column, int row) { return plane(column * 10, row * 10); });
        for (int y = 0; y < grid.ny; ++y)
            for (int x = 0; x < grid.nx; ++x) {
                const auto at = static_cast<std::size_t>(y) * grid.nx + x;
                ASSERT_EQ(fitted.has_data[at], 1) << squares << " squares, vertex " << x << ", " << y;
                ASSERT_NEAR(fitted.surface[at],
                            plane(x * static_cast<double>(grid.dx), y * static_cast<double>(grid.dx)), 2e-4)
                    << squares << " squares, vertex " << x << ", " << y;
            }
    }
}

TEST(PlaneFit, reproduces_a_plane_exactly_around_voids) {
    for (const int squares : {8, 20, 37, 64}) {
        const auto grid = grid_over(200, 160, squares).value();
        const auto fitted = fit_raster(grid, [](int column, int row) {
            const bool hole = std::hypot(column - 8, row - 9) < 3.2 || column + row < 7;
            return hole ? std::nan("") : plane(column * 10, row * 10);
        });
        int known = 0;
        for (int y = 0; y < grid.ny; ++y)
            for (int x = 0; x < grid.nx; ++x) {
                const auto at = static_cast<std::size_t>(y) * grid.nx + x;
                if (fitted.has_data[at] == 0) continue;
                ++known;
                ASSERT_NEAR(fitted.surface[at],
                            plane(x * static_cast<double>(grid.dx), y * static_cast<double>(grid.dx)), 2e-4);
            }
        EXPECT_GT(known, static_cast<int>(grid.size()) / 2);
        EXPECT_LT(known, static_cast<int>(grid.size()));
    }
}

TEST(PlaneFit, is_bilinear_if_the_raster_is_coarser) {
    const auto grid = grid_over(200, 160, 40).value();  // 5 m under 10 m
    const auto fitted = fit_raster(grid, [](int column, int row) { return column * row; });
    EXPECT_FLOAT_EQ(fitted.surface[2 * 41 + 2], 1);                      // on point 1, 1
    EXPECT_FLOAT_EQ(fitted.surface[3 * 41 + 2], 1.5);                    // between 1·1 and 1·2
    EXPECT_FLOAT_EQ(fitted.surface[3 * 41 + 3], (1 + 2 + 2 + 4) / 4.f);  // amid four
}

TEST(PlaneFit, averages_detail_finer_than_its_cells) {
    const auto grid = grid_over(200, 160, 8).value();  // 25 m over 10 m
    const auto fitted =
        fit_raster(grid, [](int column, int row) { return (column + row) % 2 == 0 ? 1.0 : -1.0; });
    for (const float height : fitted.surface) EXPECT_NEAR(height, 0, 0.4);
}

TEST(PlaneFit, has_no_data_where_most_points_are_void) {
    const auto grid = grid_over(200, 160, 20).value();
    const auto fitted = fit_raster(grid, [](int column, int) { return column < 11 ? std::nan("") : 5.0; });
    for (int x = 0; x < 21; ++x) EXPECT_EQ(fitted.has_data[5 * 21 + x], x < 11 ? 0 : 1) << x;
}

TEST(FillVoids, extrapolates_a_plane_next_to_known_ground) {
    const sim::Grid grid{12, 9, 10.f};
    std::vector<float> surface(grid.size());
    std::vector<std::uint8_t> known(grid.size(), 1);
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 12; ++x) surface[y * 12 + x] = static_cast<float>(plane(x * 10, y * 10));
    const auto whole = surface;
    for (int y = 0; y < 9; ++y) {
        known[y * 12 + 11] = 0;  // a border column
        surface[y * 12 + 11] = 0;
    }
    known[4 * 12 + 5] = 0;  // a hole
    surface[4 * 12 + 5] = 0;
    fill_voids(grid, known, surface);
    EXPECT_EQ(surface, whole);
}

TEST(FillVoids, uses_the_mean_of_filled_neighbours_farther_out) {
    const sim::Grid grid{6, 3, 1.f};
    std::vector<float> surface(grid.size());
    std::vector<std::uint8_t> known(grid.size());
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 2; ++x) {
            known[y * 6 + x] = 1;
            surface[y * 6 + x] = static_cast<float>(x);
        }
    fill_voids(grid, known, surface);
    for (int y = 0; y < 3; ++y) {
        EXPECT_FLOAT_EQ(surface[y * 6 + 2], 2);  // extrapolates 0, 1
        EXPECT_FLOAT_EQ(surface[y * 6 + 5], 2);  // then level
        EXPECT_EQ(known[y * 6 + 2], 0);
    }
}

}  // namespace
}  // namespace terrains
