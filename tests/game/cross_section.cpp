#include "game/controls/cross_section.h"

#include <cmath>

#include <gtest/gtest.h>

#include "game/session/session.h"
#include "tests/support/worlds.h"

namespace game::test {
namespace {

constexpr double kTangent = 0.6;  // of the plane, which slopes down to the north
constexpr double kZero = -100;    // m

// Under 1 m of standing layer; in its northern half flow of 0.5 m at 8 m/s in plan.
class CrossSectionOfAPlane : public testing::Test {
  protected:
    CrossSectionOfAPlane() : play_(support::plane(40, 5, kTangent, 1), support::lively(sim::Model::kBcre)) {
        sim::State& world = play_.state;
        for (int y = 20; y < world.grid.ny; ++y)
            for (int x = 0; x < world.grid.nx; ++x) world.rolling(x, y) = 0.5f, world.velocity_y(x, y) = 8;
        peaks_.speed_slope.assign(world.grid.size(), 12);
    }
    void see() { section_.see(sim::view(play_.state), peaks_); }

    support::Play play_;
    Peaks peaks_;
    CrossSection section_;
};

TEST_F(CrossSectionOfAPlane, is_empty_without_a_line) {
    see();
    EXPECT_TRUE(section_.points().empty());
    EXPECT_EQ(section_.deepest(), 0);
}

TEST_F(CrossSectionOfAPlane, has_ground_layers_and_speed_along_its_line) {
    section_.lay({{100, 20}, {100, 180}}, kZero);
    see();
    const auto points = section_.points();
    ASSERT_EQ(points.size(), CrossSection::kPoints);
    EXPECT_DOUBLE_EQ(section_.line()->length(), 160);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double y = 20 + 160 * static_cast<double>(i) / static_cast<double>(points.size() - 1);
        EXPECT_TRUE(points[i].has_data);
        EXPECT_NEAR(points[i].ground, -kTangent * y - kZero, 1e-3);
        EXPECT_NEAR(points[i].standing, 1, 1e-6);
        EXPECT_EQ(points[i].peak_speed, 12);
        if (y < 95) {
            EXPECT_EQ(points[i].rolling, 0);
            EXPECT_EQ(points[i].speed, 0);
        }
        if (y < 100) continue;
        EXPECT_NEAR(points[i].rolling, 0.5, 1e-6);
        EXPECT_NEAR(points[i].speed, 8 * std::sqrt(1 + kTangent * kTangent), 1e-3);
    }
}

TEST_F(CrossSectionOfAPlane, keeps_its_greatest_depth_until_another_line_is_laid) {
    section_.lay({{100, 20}, {100, 180}}, kZero);
    see();
    EXPECT_NEAR(section_.deepest(), 1.5, 1e-6);
    for (int y = 0; y < play_.state.grid.ny; ++y)
        for (int x = 0; x < play_.state.grid.nx; ++x) play_.state.rolling(x, y) = 0;
    see();
    EXPECT_NEAR(section_.deepest(), 1.5, 1e-6);
    section_.lay({{20, 20}, {180, 20}}, kZero);
    see();
    EXPECT_NEAR(section_.deepest(), 1, 1e-6);
}

TEST_F(CrossSectionOfAPlane, says_where_there_is_no_data) {
    play_.state.site(20, 30) = sim::Site::kDrain;
    section_.lay({{100, 20}, {100, 180}}, kZero);
    see();
    int missing = 0;
    for (const SectionPoint& point : section_.points()) missing += !point.has_data;
    EXPECT_NEAR(missing, 2 * 5 / 160.0 * 239, 1);
}

}  // namespace
}  // namespace game::test
