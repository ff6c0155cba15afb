#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/worlds.h"

// Properties of the world's own numbers, float in whole quanta, that no exact answer covers.

namespace {

using sim::Model;
using sim::Scheme;
using support::Play;

TEST(World, conserves_mass_exactly_over_a_hundred_thousand_ticks) {
    for (const auto& [model, scheme] : {std::pair(Model::kBcre, Scheme::kMuscl),
                                        std::pair(Model::kBcreInertial, Scheme::kLocalLaxFriedrichs),
                                        std::pair(Model::kVoellmy, Scheme::kLocalLaxFriedrichs)}) {
        Play play(support::rough(9, 5, 5), support::lively(model, scheme));
        std::mt19937 random(2);
        for (int tick = 0; tick < 100'000; ++tick) {
            std::vector<sim::Command> hand;
            if (tick % 500 == 0) hand.push_back(support::pour_at(random() % 45, random() % 45, 9, 40, 0.5));
            play.ticks(1, hand);
            ASSERT_EQ(play.state.ledger.mass_error(), 0) << tick;
        }
        EXPECT_GT(play.state.ledger.out, 0);
    }
}

// Random rolling material, dense and patchy, over random ground, at the greatest Courant number.
TEST(World, stays_positive_with_the_second_order_scheme_at_its_courant_limit) {
    std::mt19937 random(7);
    const auto within = [&](double most) { return most * static_cast<double>(random()) / 4294967296.0; };
    for (int round = 0; round < 60; ++round) {
        support::Ground ground({17, 17, 1});
        ground.set(ground.bedrock, [&](double x, double) { return -0.5 * x + within(1.5); });
        ground.set(ground.depth, [&](double, double) { return within(0.3); });
        ground.set(ground.rolling, [&](double, double) { return random() % 3 ? within(0.5) : 0; });
        sim::Params params = support::lively(Model::kBcre, Scheme::kMuscl);
        params.courant = 0.5f;
        params.rolling_speed = 0.5f * 60;  // half a cell per tick: one sub-step
        Play play(ground, params);
        ASSERT_EQ(sim::substeps_of(params, 1).count, 1);
        for (int tick = 0; tick < 40; ++tick) {
            play.ticks(1);
            for (int y = 0; y < 17; ++y)
                for (int x = 0; x < 17; ++x) {
                    ASSERT_GE(play.state.rolling(x, y), 0);
                    ASSERT_GE(play.state.depth(x, y), 0);
                    ASSERT_TRUE(std::isfinite(play.state.velocity_x(x, y)));
                }
            ASSERT_EQ(play.state.ledger.mass_error(), 0);
        }
    }
}

constexpr double kCell = 7.5;  // m

// Releases a loose heap on a straight slope that eases into flat ground, turned about the middle of the
// world. Returns how far downhill from the middle the farthest deposit of 5 cm is, m.
double run_out(double turned_deg) {
    constexpr int kSquares = 110;
    constexpr double kDx = kCell, kMiddle = kSquares * kDx / 2;
    const double down_x = std::sin(turned_deg * std::numbers::pi / 180),
                 down_y = std::cos(turned_deg * std::numbers::pi / 180);
    const auto along = [&](double x, double y) { return (x - kMiddle) * down_x + (y - kMiddle) * down_y; };
    const auto across = [&](double x, double y) { return (x - kMiddle) * down_y - (y - kMiddle) * down_x; };
    support::Ground ground({kSquares + 1, kSquares + 1, static_cast<float>(kDx)});
    ground.set(ground.bedrock, [&](double x, double y) {
        const double s = along(x, y), ease = 60;  // 35° above the middle, flat below
        return 0.7 * (-s + std::sqrt(s * s + ease * ease)) / 2;
    });
    ground.set(ground.rolling, [&](double x, double y) {
        return std::max(0., 3 * (1 - std::hypot(along(x, y) + 200, across(x, y)) / 60));
    });
    sim::Params params;  // loose dry snow
    params.friction = 0.2f;
    params.drag = 1500;
    params.friction_thin = 1;
    params.deposit_rate = 1.5f;
    params.deposit_speed = 6;
    params.start_slope = 0.84f;
    Play play(ground, params, {.threads = 2});
    play.until_rest(90);
    EXPECT_TRUE(sim::at_rest(play.state));
    double farthest = 0;
    for (int y = 0; y <= kSquares; ++y)
        for (int x = 0; x <= kSquares; ++x)
            if (play.state.depth(x, y) >= 0.05f) farthest = std::max(farthest, along(x * kDx, y * kDx));
    return farthest;
}

TEST(World, has_the_same_run_out_within_two_cells_at_any_angle) {
    const double straight = run_out(0);
    EXPECT_GT(straight, 50);
    for (const double turned_deg : {120., 225.})
        EXPECT_NEAR(run_out(turned_deg), straight, 2 * kCell) << turned_deg;
}

}  // namespace
