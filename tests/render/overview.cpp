#include "render/mountain/overview.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <glm/vec4.hpp>

#include "tests/render/world.h"

namespace render {
namespace {

// Slopes to the west at 30 %, with a bump, 900 m above the datum's zero.
test::World western_slope() {
    test::World world = test::make_world(
        40, 10, [](double x, double y) { return 0.3 * x + 20 * std::sin(x / 60) * std::cos(y / 50); });
    world.datum = 900;
    return world;
}

// Where the vertices lie in an image of 16 to 9, from −1 to 1.
struct Extent {
    glm::dvec2 lowest{1}, highest{-1};
};

Extent extent_in_image(const test::World& world, const Camera& camera) {
    const glm::dmat4 clip_from_world = projection_matrix(camera, 16.0 / 9.0) * view_matrix(camera);
    auto [lowest, highest] = Extent();
    for (int y = 0; y < world.grid.ny; ++y) {
        for (int x = 0; x < world.grid.nx; ++x) {
            const glm::dvec4 clip =
                clip_from_world * glm::dvec4(x * 10.0, y * 10.0, world.datum + world.bedrock(x, y), 1);
            lowest = {std::min(lowest.x, clip.x / clip.w), std::min(lowest.y, clip.y / clip.w)};
            highest = {std::max(highest.x, clip.x / clip.w), std::max(highest.y, clip.y / clip.w)};
        }
    }
    return {lowest, highest};
}

TEST(Overview, has_every_vertex_in_a_picture_of_16_to_9_and_leaves_little_of_it_empty) {
    const test::World world = western_slope();
    const auto [lowest, highest] = extent_in_image(world, overview(world.view()));
    EXPECT_GT(lowest.x, -1);
    EXPECT_GT(lowest.y, -1);
    EXPECT_LT(highest.x, 1);
    EXPECT_LT(highest.y, 1);
    EXPECT_GT(std::max(highest.x - lowest.x, highest.y - lowest.y), 1.6);  // of 2
}

TEST(Overview, stands_on_the_low_side_and_off_the_fall_line) {
    const double azimuth_deg = overview(western_slope().view()).azimuth_deg;
    EXPECT_GT(std::abs(azimuth_deg - 270), 10);
    EXPECT_LT(std::abs(azimuth_deg - 270), 45);
}

TEST(Overview, looks_at_flat_ground_from_the_south) {
    const test::World flat = test::make_world(10, 5, [](double, double) { return 3; });
    EXPECT_DOUBLE_EQ(overview(flat.view()).azimuth_deg, 180);
}

TEST(LandscapeView, has_sky_over_the_highest_ground_and_terrain_almost_from_side_to_side) {
    const test::World world = western_slope();
    const auto [lowest, highest] = extent_in_image(world, landscape_view(world.view()));
    EXPECT_NEAR(highest.y, 0.7, 1e-3);
    EXPECT_GT(highest.x - lowest.x, 1.2);  // of 2
    EXPECT_LT(highest.x, 1);
    EXPECT_GT(lowest.x, -1);
}

TEST(LandscapeView, stands_lower_than_the_overview_on_the_same_side) {
    const test::World world = western_slope();
    const Camera far = overview(world.view()), near = landscape_view(world.view());
    EXPECT_LT(near.elevation_deg, far.elevation_deg);
    EXPECT_DOUBLE_EQ(near.azimuth_deg, far.azimuth_deg);
}

}  // namespace
}  // namespace render
