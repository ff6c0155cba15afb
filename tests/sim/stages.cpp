#include "sim/bcre/stages.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "sim/bcre/inertial.h"
#include "sim/borders.h"
#include "sim/quanta.h"
#include "tests/support/worlds.h"

// Each stage against one cell worked out by hand.

namespace {

using sim::Model;
using support::lively;
using support::Play;

constexpr sim::Substep<float> kHalfQuantum{0.02f, 0.5f};  // rounds to nearest

TEST(Velocity, of_law_C_has_one_speed_down_the_slope) {
    support::Ground ground({5, 5, 2});
    ground.set(ground.bedrock, [](double x, double y) { return -0.3 * x + 0.4 * y; });
    ground.set(ground.rolling, [](double, double) { return 0.1; });
    Play play(ground, lively(Model::kBcre));
    sim::bcre::slope_velocity(play.state, play.state.params, 0, 5);
    EXPECT_NEAR(play.state.velocity_x(2, 2), 5 * 0.6, 1e-5);  // V = 5 m/s, down is (0.6, −0.8)
    EXPECT_NEAR(play.state.velocity_y(2, 2), 5 * -0.8, 1e-5);
}

TEST(Velocity, of_the_laws_slope_and_shear_grows_with_them_up_to_the_greatest) {
    support::Ground ground({5, 5, 2});
    ground.set(ground.bedrock, [](double x, double y) { return -0.3 * x + 0.4 * y; });
    ground.set(ground.rolling, [](double, double) { return 0.5; });
    sim::Params params = lively(Model::kBcre);
    params.speed_per_slope = 8;
    params.shear_rate = 12;
    const auto speed = [&](sim::Law law, float greatest) {
        params.law = law;
        params.max_speed = greatest;
        Play play(ground, params);
        sim::bcre::slope_velocity(play.state, params, 0, 5);
        EXPECT_NEAR(play.state.velocity_x(2, 2) / play.state.velocity_y(2, 2), 0.6 / -0.8, 1e-5);
        return std::hypot(play.state.velocity_x(2, 2), play.state.velocity_y(2, 2));
    };
    EXPECT_NEAR(speed(sim::Law::kSlope, 100), 8 * 0.5, 1e-5);           // μ |∇h|
    EXPECT_NEAR(speed(sim::Law::kShear, 100), 5 + 12 * 0.5 / 2, 1e-5);  // v₀ + γ̇ R / 2
    EXPECT_NEAR(speed(sim::Law::kSlope, 3), 3, 1e-5);
    EXPECT_NEAR(speed(sim::Law::kShear, 6), 6, 1e-5);
}

TEST(Velocity, of_the_inertial_model_relaxes_toward_the_terminal_one_for_half_of_a_sub_step) {
    support::Ground ground({5, 5, 2});
    ground.set(ground.bedrock, [](double x, double y) { return -0.3 * x + 0.4 * y; });
    ground.set(ground.rolling, [](double, double) { return 0.3; });
    Play play(ground, lively(Model::kBcreInertial));
    play.state.velocity_x(2, 2) = 1;
    sim::bcre::inertial_relax(play.state, play.state.params, kHalfQuantum, 0, 5);
    const double terminal = 15 * 0.5 * (0.3 / (0.3 + 0.1));  // k_v |∇z| R/(R + R_h)
    const double gained = 1 - std::exp(-0.01 / 1.5);
    EXPECT_NEAR(play.state.velocity_x(2, 2), 1 + gained * (0.6 * terminal - 1), 1e-5);
    EXPECT_NEAR(play.state.velocity_y(2, 2), gained * -0.8 * terminal, 1e-5);
}

TEST(Transport, of_the_donor_cell_carries_the_upwind_layer_at_the_joint_velocity) {
    support::Ground ground({5, 5, 2});
    ground.rolling[ground.at(1, 2)] = 0.3f;
    ground.rolling[ground.at(2, 2)] = 0.1f;
    Play play(ground, lively(Model::kBcre));
    play.state.velocity_x(1, 2) = 4;
    play.state.velocity_x(2, 2) = -2;
    sim::bcre::fluxes_local_lax_friedrichs(play.state, play.scratch, kHalfQuantum, 0, 5);
    const double joint = (0.3 * 4 - 0.1 * 2) / 0.4;
    EXPECT_NEAR(play.scratch.flux_x(1, 2), joint * 0.3 * 0.02 / 2, 1e-6);
}

TEST(Transport, of_lax_friedrichs_averages_four_neighbours) {
    support::Ground ground({5, 5, 2});
    ground.rolling[ground.at(2, 2)] = 0.4f;
    Play play(ground, lively(Model::kBcre, sim::Scheme::kLaxFriedrichs));
    play.state.velocity_x(2, 2) = 3;
    sim::bcre::fluxes_lax_friedrichs(play.state, play.scratch, kHalfQuantum, 0, 5);
    EXPECT_NEAR(play.scratch.flux_x(2, 2), 0.5 * 0.4 * 3 * 0.01 + 0.25 * 0.4, 1e-6);
    EXPECT_NEAR(play.scratch.flux_x(1, 2), 0.5 * 0.4 * 3 * 0.01 - 0.25 * 0.4, 1e-6);
    EXPECT_NEAR(play.scratch.flux_y(2, 2), 0.25 * 0.4, 1e-6);
}

TEST(Transport, of_minmod_takes_the_layer_at_the_face) {
    support::Ground ground({7, 5, 2});
    const float depths[] = {0, 0.1f, 0.3f, 0.4f, 0.6f, 0.6f, 0};
    for (int x = 0; x < 7; ++x) ground.rolling[ground.at(x, 2)] = depths[x];
    Play play(ground, lively(Model::kBcreInertial));
    for (int x = 0; x < 7; ++x) play.state.velocity_x(x, 2) = 2;
    sim::bcre::fluxes_minmod(play.state, play.scratch, kHalfQuantum, 0, 5);
    EXPECT_NEAR(play.scratch.flux_x(2, 2), 2 * 0.01 * (0.3 + 0.05), 1e-7);  // minmod(.2, .1) = .1
    EXPECT_NEAR(play.scratch.flux_x(5, 2), 2 * 0.01 * 0.6, 1e-7);           // a maximum keeps its own
}

TEST(Transport, never_takes_more_than_a_vertex_has) {
    std::mt19937 random(3);
    support::Ground ground = support::rough(20, 1, 9);
    Play play(ground, lively(Model::kBcreInertial));
    for (int round = 0; round < 50; ++round) {
        for (int y = -1; y < 23; ++y)
            for (int x = -1; x < 21; ++x) {
                play.scratch.flux_x(x, y) = static_cast<float>(random() % 2001 - 1000.0) * 1e-3f;
                play.scratch.flux_y(x, y) = static_cast<float>(random() % 2001 - 1000.0) * 1e-3f;
            }
        // From outside comes nothing: the halo is empty.
        for (int y = -1; y < 23; ++y) play.scratch.flux_x(-1, y) = play.scratch.flux_x(20, y) = 0;
        for (int x = -1; x < 21; ++x) play.scratch.flux_y(x, -1) = play.scratch.flux_y(x, 22) = 0;
        const sim::Substep<float> sub{0.02f, sim::dither_of(round)};
        sim::bcre::limit_outflow(play.state, play.scratch, 0, 23);
        sim::bcre::round_fluxes(play.state, play.scratch, sub, 0, 23);
        sim::bcre::carry(play.state, play.scratch, 0, 23);
        double before = 0, after = 0;
        for (int y = 0; y < 23; ++y)
            for (int x = 0; x < 21; ++x) {
                before += static_cast<double>(play.state.rolling(x, y));
                after += static_cast<double>(play.scratch.rolling(x, y));
                ASSERT_GE(play.scratch.rolling(x, y), 0);
            }
        ASSERT_EQ(before, after);  // whole quanta: sums in double are exact
    }
}

TEST(Transport, mixes_velocities_by_mass) {
    support::Ground ground({5, 5, 1});
    ground.rolling[ground.at(2, 2)] = 0.5f;
    ground.rolling[ground.at(1, 2)] = 0.5f;
    Play play(ground, lively(Model::kBcreInertial));
    play.state.velocity_x(2, 2) = 1;
    play.state.velocity_x(1, 2) = 5;
    play.scratch.flux_x(1, 2) = 0.25f;
    sim::bcre::carry(play.state, play.scratch, 0, 5);
    EXPECT_EQ(play.scratch.rolling(2, 2), 0.75f);
    EXPECT_NEAR(play.scratch.velocity_x(2, 2), (0.5 * 1 + 0.25 * 5) / 0.75, 1e-6);
    EXPECT_NEAR(play.scratch.velocity_x(1, 2), 5, 1e-6);
}

TEST(LowerSlope, looks_at_lower_neighbours_only_and_sees_a_checkerboard) {
    support::Ground ground({5, 5, 2});
    ground.bedrock[ground.at(2, 2)] = 1;
    Play play(ground, lively(Model::kBcre));
    sim::bcre::lower_slope(play.state, play.scratch, 0, 5);
    EXPECT_NEAR(play.scratch.slope(2, 2), std::sqrt(2.0) * 0.5, 1e-6);
    EXPECT_NEAR(play.scratch.slope_spread(2, 2), std::sqrt(2.0), 1e-6);
    EXPECT_EQ(play.scratch.slope(1, 2), 0);  // beside it only a higher one
}

TEST(Exchange, grows_and_decays_as_the_exponential) {
    support::Ground ground = support::plane(6, 2, 0.8, 3);
    ground.set(ground.rolling, [](double, double) { return 0.05; });
    Play play(ground, lively(Model::kBcre));
    sim::fill_borders(play.state, play.state.params);
    sim::bcre::lower_slope(play.state, play.scratch, 0, 7);
    sim::bcre::exchange(play.state, play.state.params, play.scratch, kHalfQuantum, 0, 7);
    EXPECT_NEAR(play.state.rolling(3, 3), 0.05 * std::exp(2 * 0.3 * 0.02), 1e-5);  // γ p Δt, p = .8 − .5
    EXPECT_EQ(play.state.rolling(3, 3) + play.state.depth(3, 3), 3 + sim::nearest_quanta(0.05f));
}

TEST(Exchange, never_carries_the_slope_past_its_threshold) {
    std::mt19937 random(17);
    const auto within = [&](double least, double most) {
        return least + (most - least) * static_cast<double>(random()) / 4294967296.0;
    };
    for (int round = 0; round < 2000; ++round) {
        support::Ground ground({3, 3, 1});
        const double deep = within(0, 1);
        ground.set(ground.bedrock, [&](double, double) { return within(-1, 1); });
        ground.depth[ground.at(1, 1)] = 20;
        ground.bedrock[ground.at(1, 1)] -= 20;
        ground.rolling[ground.at(1, 1)] = static_cast<float>(deep * 10);
        sim::Params params = lively(Model::kBcre);
        params.exchange_rate = static_cast<float>(within(0, 50));
        Play play(ground, params);
        sim::bcre::lower_slope(play.state, play.scratch, 1, 2);
        const float before = play.scratch.slope(1, 1) - params.stop_slope;
        sim::bcre::exchange(play.state, params, play.scratch, kHalfQuantum, 1, 2);
        sim::bcre::lower_slope(play.state, play.scratch, 1, 2);
        const float after = play.scratch.slope(1, 1) - params.stop_slope;
        const float slack = 2e-5f;  // a quantum and float32
        if (before > 0) {
            ASSERT_GE(after, -slack) << round;
        } else {
            ASSERT_LE(after, slack) << round;
        }
    }
}

TEST(InertialTransport, takes_layer_and_momentum_at_the_face) {
    support::Ground ground({7, 5, 2});
    const float depths[] = {0, 0.1f, 0.3f, 0.4f, 0.6f, 0.6f, 0}, speeds[] = {0, 1, 2, 4, 4, 4, 0};
    for (int x = 0; x < 7; ++x) ground.rolling[ground.at(x, 2)] = depths[x];
    Play play(ground, lively(Model::kBcreInertial));
    for (int x = 0; x < 7; ++x) play.state.velocity_x(x, 2) = speeds[x];
    sim::bcre::inertial_fluxes(play.state, play.state.rolling, play.scratch, kHalfQuantum, 0, 5);
    // Between 0.3 m at 2 m/s and 0.4 m at 4: the slopes of R are 0.15 and 0.15, those of u 1.5 and 0.
    const double left = 0.3 + 0.075, right = 0.4 - 0.075, joint = (left * 2.75 + right * 4) / (left + right);
    const double flux = left * joint * 0.02 / 2;
    EXPECT_NEAR(play.scratch.flux_x(2, 2), flux, 1e-6);
    EXPECT_NEAR(play.scratch.momentum_x.u(2, 2), flux * 2.75, 2e-6);
    EXPECT_EQ(play.scratch.momentum_x.v(2, 2), 0);
    EXPECT_EQ(play.scratch.flux_x(0, 2), 0);  // what is empty gives nothing
    EXPECT_EQ(play.scratch.flux_y(2, 2), 0);
}

TEST(InertialTransport, takes_a_quarter_of_a_vertex_through_a_face_at_most) {
    support::Ground ground({5, 5, 1});
    ground.rolling[ground.at(2, 2)] = 0.5f;
    Play play(ground, lively(Model::kBcreInertial));
    play.state.velocity_x(2, 2) = 1000;
    sim::bcre::inertial_fluxes(play.state, play.state.rolling, play.scratch, kHalfQuantum, 0, 5);
    EXPECT_EQ(play.scratch.flux_x(2, 2), 0.125f);
}

// A stage of the exchange alone, on what rolls with `speed`; where it leads stands in scratch.
void exchange_stage(Play& play, float speed) {
    play.state.velocity_y.fill(speed);
    sim::fill_borders(play.state, play.state.params);
    sim::bcre::inertial_exchange(play.state, play.state.params, play.scratch, kHalfQuantum, 0, 5);
    sim::bcre::inertial_predict(play.state, play.scratch, 0, 5);
}

TEST(InertialExchange, deposits_nothing_above_the_deposit_speed) {
    for (const float speed : {2.f, 3.f}) {  // the gate is at 2.5 m/s
        support::Ground ground = support::plane(4, 2, 0.1);
        ground.set(ground.rolling, [](double, double) { return 0.5; });
        Play play(ground, lively(Model::kBcreInertial));
        exchange_stage(play, speed);
        const double stop = 0.36 + (0.5 - 0.36) * std::exp(-5.);  // of 0.5 m
        EXPECT_NEAR(play.scratch.depth(2, 2), 2 * 0.5 * (stop - 0.1) * std::max(0., 1 - speed / 2.5) * 0.02,
                    1e-6);
        EXPECT_EQ(play.scratch.velocity_y(2, 2), speed);  // what stays moving keeps its speed
    }
}

TEST(InertialExchange, does_nothing_between_stop_and_erosion_slope) {
    support::Ground ground = support::plane(4, 2, 0.52, 1);  // stop .5, erosion .55
    ground.set(ground.rolling, [](double, double) { return 0.5; });
    Play play(ground, lively(Model::kBcreInertial));
    exchange_stage(play, 1);
    EXPECT_EQ(play.scratch.depth(2, 2), 1);
}

TEST(InertialExchange, erodes_smoothly_from_the_erosion_depth_on_and_from_rest) {
    for (const double rolling : {0.04, 0.06, 0.5}) {
        support::Ground ground = support::plane(4, 2, 0.9, 1);
        ground.set(ground.rolling, [&](double, double) { return rolling; });
        Play play(ground, lively(Model::kBcreInertial));
        exchange_stage(play, 4);
        const double above = std::max(0., rolling - 0.05), eroded = 2 * above * above / rolling * 0.35 * 0.02;
        EXPECT_NEAR(play.scratch.rolling(2, 2), rolling + eroded, 1e-5) << rolling;
        EXPECT_NEAR(play.scratch.rolling(2, 2) * play.scratch.velocity_y(2, 2), rolling * 4, 1e-4) << rolling;
    }
}

// Slopes toward the lower neighbours, then yield.
void yield_stage(Play& play) {
    sim::fill_borders(play.state, play.state.params);
    sim::bcre::lower_slope(play.state, play.scratch, 0, 5);
    sim::bcre::inertial_yield(play.state, play.state.params, play.scratch, 0, 5);
}

TEST(Yield, starts_above_the_start_slope_and_freezes_what_is_thin_and_slow) {
    sim::Params params = lively(Model::kBcreInertial);
    params.anchor_gain = params.anchor_margin = params.anchor_step = 0;
    Play play(support::plane(4, 2, 0.75, 1), params);  // start .7
    yield_stage(play);
    EXPECT_NEAR(play.state.rolling(2, 2), params.start_depth, 1e-5);

    support::Ground gentle = support::plane(4, 2, 0.4, 1);
    gentle.set(gentle.rolling, [](double, double) { return 0.004; });
    for (const float speed : {1.f, 4.f}) {
        Play thin(gentle, params);
        thin.state.velocity_y.fill(speed);
        yield_stage(thin);
        EXPECT_EQ(thin.state.rolling(2, 2) == 0, speed < params.deposit_speed) << speed;
    }
}

TEST(Yield, starts_what_lies_loose_on_natural_ground_above_the_erosion_slope_and_not_the_ground) {
    const sim::Params params = lively(Model::kBcreInertial);
    for (const double tangent : {0.5, 0.6}) {  // erosion .55, start .7
        Play play(support::plane(4, 2, tangent, 1), params);
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 5; ++x) play.state.depth(x, y) += 0.125f;
        yield_stage(play);
        EXPECT_EQ(play.state.rolling(2, 2), tangent > 0.55 ? 0.125f : 0.f);
        EXPECT_EQ(play.state.depth(2, 2), tangent > 0.55 ? 1.f : 1.125f);
    }
}

TEST(Yield, of_bcre_starts_above_the_start_slope_whatever_the_ground_was) {
    Play play(support::plane(4, 2, 0.75, 1), lively(Model::kBcre));  // start .7
    sim::fill_borders(play.state, play.state.params);
    sim::bcre::lower_slope(play.state, play.scratch, 0, 5);
    sim::bcre::yield(play.state, play.state.params, play.scratch, 0, 5);
    EXPECT_NEAR(play.state.rolling(2, 2), play.state.params.start_depth, 1e-5);
}

TEST(Yield, holds_natural_ground_that_is_steep_from_the_first) {
    const support::Ground steep = support::plane(20, 2, 1.1, 1);
    Play anchored(steep, lively(Model::kBcreInertial));
    anchored.ticks(60);
    EXPECT_EQ(anchored.state.ledger.rolling, 0);
    sim::Params params = lively(Model::kBcreInertial);
    params.anchor_gain = params.anchor_margin = params.anchor_step = 0;
    Play loose(steep, params);
    loose.ticks(60);
    EXPECT_GT(loose.state.ledger.rolling, 0);
}

}  // namespace
