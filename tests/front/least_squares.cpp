#include "sim/front/least_squares.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using sim::front::LeastSquares;

TEST(LeastSquares, finds_a_unique_solution) {
    LeastSquares rows;
    rows.add({2, 1}, 2 * 3 + 1 * -4);
    rows.add({-1, 1}, -1 * 3 + 1 * -4);
    EXPECT_NEAR(rows.solve().x, 3, 1e-12);
    EXPECT_NEAR(rows.solve().y, -4, 1e-12);
}

TEST(LeastSquares, minimises_the_residual) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int round = 0; round < 100; ++round) {
        LeastSquares rows;
        std::vector<std::pair<glm::dvec2, double>> all;
        for (int i = 0; i < 5; ++i) all.push_back({{any(random), any(random)}, any(random)});
        for (const auto& [a, b] : all) rows.add(a, b);
        const glm::dvec2 r = rows.solve();
        glm::dvec2 gradient(0, 0);
        for (const auto& [a, b] : all) gradient += (a.x * r.x + a.y * r.y - b) * a;
        EXPECT_NEAR(gradient.x, 0, 1e-9);
        EXPECT_NEAR(gradient.y, 0, 1e-9);
    }
}

// One edge, or several in one direction: the solution lies along them, as the paper chooses for n = 1.
TEST(LeastSquares, gives_the_shortest_solution_for_rows_on_one_line) {
    for (const glm::dvec2 along : {glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(3, -4),
                                   glm::dvec2(1e-3, 2e-3), glm::dvec2(4e3, 7e3)}) {
        LeastSquares rows;
        const double length2 = along.x * along.x + along.y * along.y;
        rows.add(along, 5);
        rows.add(-2.0 * along, -10);
        EXPECT_NEAR(rows.solve().x, 5 * along.x / length2, 1e-9 * std::sqrt(length2) * 5 / length2);
        EXPECT_NEAR(rows.solve().y, 5 * along.y / length2, 1e-9 * std::sqrt(length2) * 5 / length2);
    }
}

TEST(LeastSquares, without_rows_gives_zero) {
    EXPECT_EQ(LeastSquares{}.solve(), glm::dvec2(0, 0));
    LeastSquares rows;
    rows.add({0, 0}, 3);
    EXPECT_EQ(rows.solve(), glm::dvec2(0, 0));
}

}  // namespace
