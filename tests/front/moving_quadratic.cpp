#include "sim/front/moving_quadratic.h"

#include <gtest/gtest.h>

namespace {

using sim::front::MovingQuadratic;

TEST(MovingQuadratic, finds_the_front_that_rows_lie_on) {
    const auto front = [](double s, double z) {
        return 0.3 - 0.2 * s + 0.1 * s * s / 2 + z * (0.8 + 0.05 * s) + 0.4 * z * z / 2;
    };
    MovingQuadratic fit;
    for (double s = -2; s <= 2; s += 0.5)
        for (double z = -2; z <= 0; z += 0.25) fit.sums.add(s, z, front(s, z), 1e6);
    fit.solve();
    for (const double s : {-1.5, 0.0, 0.7}) {
        EXPECT_NEAR(fit.at(s, 0), front(s, 0), 1e-4);
        EXPECT_NEAR(fit.at(s, -1), front(s, -1), 1e-4);
        EXPECT_NEAR(fit.slope(s), -0.2 + 0.1 * s, 1e-4);
        EXPECT_NEAR(fit.speed(s), 0.8 + 0.05 * s, 1e-4);
    }
}

TEST(MovingQuadratic, is_straight_and_steady_without_evidence) {
    MovingQuadratic fit;
    fit.sums.add(0, 0, 0.25, 100);
    fit.solve();
    EXPECT_NEAR(fit.at(0, 0), 0.25, 1e-3);
    EXPECT_NEAR(fit.slope(0), 0, 1e-9);
    EXPECT_NEAR(fit.speed(0), 0, 1e-9);
}

TEST(MovingQuadratic, follows_rows_with_larger_weights) {
    MovingQuadratic fit;
    fit.sums.add(0, 0, 0, 1);
    fit.solve();
    EXPECT_NEAR(fit.at(0, 0), 0, 1e-6);
    fit.sums.add(0, 0, 1, 99);
    fit.solve();
    EXPECT_NEAR(fit.at(0, 0), 0.99, 1e-3);
}

}  // namespace
