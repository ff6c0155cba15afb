#include "render/view/wind.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace render {
namespace {

TEST(Wind, blows_away_from_where_it_comes_from) {
    EXPECT_EQ(velocity({0, 5}), glm::vec2(0, -5)) << "from north";
    EXPECT_EQ(velocity({90, 5}), glm::vec2(-5, 0)) << "from east";
    EXPECT_EQ(velocity({180, 5}), glm::vec2(0, 5));
    EXPECT_EQ(velocity({-90, 5}), glm::vec2(5, 0));
    EXPECT_EQ(velocity({33, 0}), glm::vec2(0, 0));
}

TEST(Wind, has_its_speed_and_its_direction_at_any_angle) {
    for (int halves = -720; halves <= 720; ++halves) {
        const double from = halves / 2.0;
        const glm::vec2 blows = velocity({from, 10});
        EXPECT_NEAR(blows.x, -10 * std::sin(glm::radians(from)), 1e-5) << from;
        EXPECT_NEAR(blows.y, -10 * std::cos(glm::radians(from)), 1e-5) << from;
    }
}

}  // namespace
}  // namespace render
