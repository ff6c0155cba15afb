#include "sim/bcre/stages.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "sim/bcre/constants.h"
#include "sim/bcre/plain.h"
#include "sim/borders.h"
#include "sim/quanta.h"
#include "tests/support/worlds.h"

// Each stage against one cell worked out by hand.

namespace {

using sim::Model;
using support::lively;
using support::Play;

constexpr sim::Substep<float> kHalfQuantum{0.02f, 0.5f};  // rounds to nearest

// The plain stages of `bcre` on a world, in their order.
struct Stages {
    Play play;
    sim::Scratch<float>& scratch;
    sim::bcre::Constants<float> c;
    sim::Scheme scheme;

    Stages(const support::Ground& ground, const sim::Params& params)
        : play(ground, params, {.plain = true}),
          scratch(*play.engine.scratch),
          c(sim::bcre::constants_of(params, ground.grid.dx, kHalfQuantum)),
          scheme(params.scheme) {}

    int rows() const { return play.state.grid.ny; }
    void find_slope() {
        sim::fill_borders(play.state, play.state.params);
        sim::bcre::find_slope(play.state, scratch, scheme, 0, rows());
        sim::bcre::find_pace(play.state, scratch, c, 0, rows());
    }
    void find_gives() { sim::bcre::find_gives(play.state, scratch, scheme, c, 0, rows()); }
    void find_velocity() {
        sim::fill_borders(play.state, play.state.params);
        sim::bcre::find_velocity(play.state, c, 0, rows());
    }
    void exchange() {
        sim::bcre::find_exchange(play.state, scratch, scheme, c, 0, rows());
        sim::bcre::settle(play.state, scratch, c, 0, rows());
    }
};

TEST(Velocity, of_law_C_has_one_speed_down_the_slope) {
    support::Ground ground({5, 5, 2});
    ground.set(ground.bedrock, [](double x, double y) { return -0.3 * x + 0.4 * y; });
    ground.set(ground.rolling, [](double, double) { return 0.1; });
    Stages stages(ground, lively(Model::kBcre));
    stages.find_velocity();
    EXPECT_NEAR(stages.play.state.velocity_x(2, 2), 5 * 0.6, 1e-5);  // V = 5 m/s, down is (0.6, −0.8)
    EXPECT_NEAR(stages.play.state.velocity_y(2, 2), 5 * -0.8, 1e-5);
}

TEST(Velocity, of_bcre_is_nowhere_where_nothing_rolls) {
    Stages stages(support::plane(4, 2, 0.5, 1), lively(Model::kBcre));
    stages.find_velocity();
    EXPECT_EQ(stages.play.state.velocity_y(2, 2), 0);
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
        Stages stages(ground, params);
        stages.find_velocity();
        const float u = stages.play.state.velocity_x(2, 2), v = stages.play.state.velocity_y(2, 2);
        EXPECT_NEAR(u / v, 0.6 / -0.8, 1e-5);
        return std::hypot(u, v);
    };
    EXPECT_NEAR(speed(sim::Law::kSlope, 100), 8 * 0.5, 1e-5);           // μ |∇h|
    EXPECT_NEAR(speed(sim::Law::kShear, 100), 5 + 12 * 0.5 / 2, 1e-5);  // v₀ + γ̇ R / 2
    EXPECT_NEAR(speed(sim::Law::kSlope, 3), 3, 1e-5);
    EXPECT_NEAR(speed(sim::Law::kShear, 6), 6, 1e-5);
}

TEST(Velocity, of_the_inertial_model_relaxes_toward_the_terminal_one) {
    support::Ground ground({5, 5, 2});
    ground.set(ground.bedrock, [](double x, double y) { return -0.3 * x + 0.4 * y; });
    ground.set(ground.rolling, [](double, double) { return 0.3; });
    Play play(ground, lively(Model::kBcreInertial));
    play.state.velocity_x(2, 2) = 1;
    sim::bcre::accelerate(play.state, play.state.params, kHalfQuantum, 0, 5);
    const double terminal = 15 * 0.5 * (0.3 / (0.3 + 0.1));  // k_v |∇z| R/(R + R_h)
    const double gained = 1 - std::exp(-0.02 / 1.5);
    EXPECT_NEAR(play.state.velocity_x(2, 2), 1 + gained * (0.6 * terminal - 1), 1e-5);
    EXPECT_NEAR(play.state.velocity_y(2, 2), gained * -0.8 * terminal, 1e-5);
}

TEST(Gives, of_local_lax_friedrichs_go_to_the_lower_neighbours_by_their_drops) {
    support::Ground ground({5, 5, 2});
    ground.set(ground.bedrock, [](double x, double y) { return -0.3 * x + 0.4 * y; });
    ground.rolling[ground.at(2, 2)] = 0.4f;
    Stages stages(ground, lively(Model::kBcre));
    stages.find_slope();
    stages.find_gives();
    EXPECT_NEAR(stages.scratch.given.east(2, 2), 0.4 * 5 * 0.6 * 0.01, 1e-7);  // R v_E Δt/Δx
    EXPECT_NEAR(stages.scratch.given.south(2, 2), 0.4 * 5 * 0.8 * 0.01, 1e-7);
    EXPECT_EQ(stages.scratch.given.west(2, 2), 0);
    EXPECT_EQ(stages.scratch.given.north(2, 2), 0);
}

TEST(Gives, of_a_ridge_go_to_both_sides) {
    support::Ground ground({5, 5, 2});
    ground.set(ground.bedrock, [](double x, double) { return -std::fabs(x - 4); });
    ground.rolling[ground.at(2, 2)] = 0.4f;
    Stages stages(ground, lively(Model::kBcre));
    stages.find_slope();
    stages.find_gives();
    EXPECT_NEAR(stages.scratch.given.east(2, 2), 0.4 * 5 * 0.01, 1e-7);
    EXPECT_EQ(stages.scratch.given.east(2, 2), stages.scratch.given.west(2, 2));
}

TEST(Gives, of_lax_friedrichs_are_quarters_and_more_of_them_downhill) {
    support::Ground ground({5, 5, 2});
    ground.set(ground.bedrock, [](double x, double) { return -0.5 * x; });
    ground.rolling[ground.at(2, 2)] = 0.4f;
    Stages stages(ground, lively(Model::kBcre, sim::Scheme::kLaxFriedrichs));
    stages.find_slope();
    stages.find_gives();
    const double quarter = 0.25 * 0.4, half = 0.5 * 0.4 * 5 * 0.01;
    EXPECT_NEAR(stages.scratch.given.east(2, 2), quarter + half, 1e-5);
    EXPECT_NEAR(stages.scratch.given.west(2, 2), quarter - half, 1e-5);
    EXPECT_NEAR(stages.scratch.given.north(2, 2), quarter, 1e-5);
}

TEST(Gives, of_muscl_take_layer_and_velocity_at_the_face) {
    support::Ground ground({7, 5, 2});
    const float depths[] = {0, 0.1f, 0.3f, 0.4f, 0.6f, 0.6f, 0};
    for (int x = 0; x < 7; ++x) ground.rolling[ground.at(x, 2)] = depths[x];
    Stages stages(ground, lively(Model::kBcre, sim::Scheme::kMuscl));
    for (int x = 0; x < 7; ++x) stages.scratch.velocity_x(x, 2) = x == 3 ? 4 : 2;
    stages.find_gives();
    EXPECT_NEAR(stages.scratch.given.east(2, 2), 3 * 0.01 * (0.3 + 0.05), 1e-7);  // minmod(.2, .1) = .1
    EXPECT_NEAR(stages.scratch.given.east(5, 2), 2 * 0.01 * 0.6, 1e-7);           // a maximum keeps its own
    EXPECT_EQ(stages.scratch.given.west(2, 2), 0);
}

TEST(Gives, never_are_more_than_a_vertex_has) {
    std::mt19937 random(3);
    for (const auto scheme :
         {sim::Scheme::kLaxFriedrichs, sim::Scheme::kLocalLaxFriedrichs, sim::Scheme::kMuscl}) {
        support::Ground ground = support::rough(20, 1, 9);
        // Films of a few quanta too, on peaks and pits, at the greatest Courant number there is.
        ground.set(ground.rolling, [&](double, double) {
            return random() % 2 ? static_cast<double>(random() % 40) * static_cast<double>(sim::kQuantum)
                                : static_cast<double>(random() % 1000) * 1e-3;
        });
        sim::Params params = lively(Model::kBcre, scheme);
        params.rolling_speed = 25;  // half a cell in a sub-step
        for (int round = 0; round < 50; ++round) {
            Stages stages(ground, params);
            stages.c = sim::bcre::constants_of(params, 1, sim::Substep<float>{0.02f, sim::dither_of(round)});
            stages.find_slope();
            sim::bcre::find_central_velocity(stages.play.state, stages.scratch, stages.c, 0, stages.rows());
            sim::bcre::continue_velocity(stages.scratch);
            stages.find_gives();
            sim::bcre::book_gives(stages.play.state, stages.scratch, scheme, stages.c, 0, stages.rows());
            sim::bcre::carry_gives(stages.play.state, stages.scratch, 0, stages.rows());
            double before = 0, after = 0;
            for (int y = 0; y < 23; ++y)
                for (int x = 0; x < 21; ++x) {
                    before += static_cast<double>(stages.play.state.rolling(x, y));
                    after += static_cast<double>(stages.scratch.rolling(x, y));
                    ASSERT_GE(stages.scratch.rolling(x, y), 0) << sim::to_string(scheme);
                }
            const auto out = static_cast<double>(sim::drained(stages.scratch, Model::kBcre));
            // whole quanta: sums in double are exact
            ASSERT_EQ(before, after + out * static_cast<double>(sim::kQuantum)) << sim::to_string(scheme);
        }
    }
}

TEST(Transport, of_minmod_takes_the_layer_at_the_face) {
    support::Ground ground({7, 5, 2});
    const float depths[] = {0, 0.1f, 0.3f, 0.4f, 0.6f, 0.6f, 0};
    for (int x = 0; x < 7; ++x) ground.rolling[ground.at(x, 2)] = depths[x];
    Play play(ground, lively(Model::kBcreInertial));
    for (int x = 0; x < 7; ++x) play.state.velocity_x(x, 2) = 2;
    sim::bcre::fluxes_minmod(play.state, (*play.engine.scratch), kHalfQuantum, 0, 5);
    EXPECT_NEAR((*play.engine.scratch).flux_x(2, 2), 2 * 0.01 * (0.3 + 0.05), 1e-7);  // minmod(.2, .1) = .1
    EXPECT_NEAR((*play.engine.scratch).flux_x(5, 2), 2 * 0.01 * 0.6, 1e-7);           // a maximum keeps its own
}

TEST(Transport, never_takes_more_than_a_vertex_has) {
    std::mt19937 random(3);
    support::Ground ground = support::rough(20, 1, 9);
    Play play(ground, lively(Model::kBcreInertial));
    for (int round = 0; round < 50; ++round) {
        for (int y = -1; y < 23; ++y)
            for (int x = -1; x < 21; ++x) {
                (*play.engine.scratch).flux_x(x, y) = static_cast<float>(random() % 2001 - 1000.0) * 1e-3f;
                (*play.engine.scratch).flux_y(x, y) = static_cast<float>(random() % 2001 - 1000.0) * 1e-3f;
            }
        // From outside comes nothing: the halo is empty.
        for (int y = -1; y < 23; ++y) (*play.engine.scratch).flux_x(-1, y) = (*play.engine.scratch).flux_x(20, y) = 0;
        for (int x = -1; x < 21; ++x) (*play.engine.scratch).flux_y(x, -1) = (*play.engine.scratch).flux_y(x, 22) = 0;
        const sim::Substep<float> sub{0.02f, sim::dither_of(round)};
        sim::bcre::limit_outflow(play.state, (*play.engine.scratch), 0, 23);
        sim::bcre::round_fluxes(play.state, (*play.engine.scratch), sub, 0, 23);
        sim::bcre::carry(play.state, (*play.engine.scratch), 0, 23);
        double before = 0, after = 0;
        for (int y = 0; y < 23; ++y)
            for (int x = 0; x < 21; ++x) {
                before += static_cast<double>(play.state.rolling(x, y));
                after += static_cast<double>((*play.engine.scratch).rolling(x, y));
                ASSERT_GE((*play.engine.scratch).rolling(x, y), 0);
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
    (*play.engine.scratch).flux_x(1, 2) = 0.25f;
    sim::bcre::carry(play.state, (*play.engine.scratch), 0, 5);
    EXPECT_EQ((*play.engine.scratch).rolling(2, 2), 0.75f);
    EXPECT_NEAR((*play.engine.scratch).velocity_x(2, 2), (0.5 * 1 + 0.25 * 5) / 0.75, 1e-6);
    EXPECT_NEAR((*play.engine.scratch).velocity_x(1, 2), 5, 1e-6);
}

TEST(LowerSlope, looks_at_lower_neighbours_only_and_sees_a_checkerboard) {
    support::Ground ground({5, 5, 2});
    ground.bedrock[ground.at(2, 2)] = 1;
    Stages stages(ground, lively(Model::kBcre));
    stages.find_slope();
    EXPECT_NEAR(stages.scratch.fall(2, 2), std::sqrt(2.0), 1e-6);
    EXPECT_EQ(stages.scratch.fall(1, 2), 0);  // beside it only a higher one
}

TEST(Exchange, grows_and_decays_as_the_exponential) {
    support::Ground ground = support::plane(6, 2, 0.8, 3);
    ground.set(ground.rolling, [](double, double) { return 0.05; });
    Stages stages(ground, lively(Model::kBcre));
    stages.find_slope();
    stages.exchange();
    const sim::State& state = stages.play.state;
    EXPECT_NEAR(state.rolling(3, 3), 0.05 * std::exp(2 * 0.3 * 0.02), 1e-5);  // γ p Δt, p = .8 − .5
    EXPECT_EQ(state.rolling(3, 3) + state.depth(3, 3), 3 + sim::nearest_quanta(0.05f));
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
        if (round % 2) params.exchange_depth = static_cast<float>(within(0.01, 5));
        params.start_slope = 10;
        Stages stages(ground, params);
        stages.find_slope();
        const float before = stages.scratch.fall(1, 1) - params.stop_slope;
        stages.exchange();
        stages.find_slope();
        const float after = stages.scratch.fall(1, 1) - params.stop_slope;
        const float slack = 2e-5f;  // a quantum and float32
        if (before > 0) {
            ASSERT_GE(after, -slack) << round;
        } else {
            ASSERT_LE(after, slack) << round;
        }
    }
}

TEST(Exchange, of_the_inertial_model_deposits_nothing_above_the_deposit_speed) {
    for (const float speed : {2.f, 3.f}) {  // the gate is at 2.5 m/s
        support::Ground ground = support::plane(4, 2, 0.1);
        ground.set(ground.rolling, [](double, double) { return 0.5; });
        Play play(ground, lively(Model::kBcreInertial));
        play.state.velocity_y.fill(speed);
        sim::fill_borders(play.state, play.state.params);
        sim::bcre::lower_slope(play.state, (*play.engine.scratch), 0, 5);
        sim::bcre::exchange_inertial(play.state, play.state.params, (*play.engine.scratch), kHalfQuantum, 0, 5);
        if (speed < 2.5f)
            EXPECT_GT(play.state.depth(2, 2), 0);
        else
            EXPECT_EQ(play.state.depth(2, 2), 0);
        EXPECT_EQ(play.state.velocity_y(2, 2), speed);  // what stays moving keeps its speed
    }
}

TEST(Exchange, of_the_inertial_model_does_nothing_between_stop_and_erosion_slope) {
    support::Ground ground = support::plane(4, 2, 0.52, 1);  // stop .5, erosion .55
    ground.set(ground.rolling, [](double, double) { return 0.5; });
    Play play(ground, lively(Model::kBcreInertial));
    sim::fill_borders(play.state, play.state.params);
    sim::bcre::lower_slope(play.state, (*play.engine.scratch), 0, 5);
    sim::bcre::exchange_inertial(play.state, play.state.params, (*play.engine.scratch), kHalfQuantum, 0, 5);
    EXPECT_EQ(play.state.depth(2, 2), 1);
}

TEST(Exchange, starts_what_it_erodes_from_rest) {
    support::Ground ground = support::plane(4, 2, 0.9, 1);
    ground.set(ground.rolling, [](double, double) { return 0.5; });
    Play play(ground, lively(Model::kBcreInertial));
    play.state.velocity_y.fill(4);
    sim::fill_borders(play.state, play.state.params);
    sim::bcre::lower_slope(play.state, (*play.engine.scratch), 0, 5);
    sim::bcre::exchange_inertial(play.state, play.state.params, (*play.engine.scratch), kHalfQuantum, 0, 5);
    ASSERT_GT(play.state.rolling(2, 2), 0.5f);
    EXPECT_NEAR(play.state.rolling(2, 2) * play.state.velocity_y(2, 2), 0.5f * 4, 1e-5);
}

TEST(Yield, starts_above_the_start_slope_and_freezes_what_is_thin_and_slow) {
    sim::Params params = lively(Model::kBcreInertial);
    params.anchor_gain = params.anchor_margin = 0;
    support::Ground ground = support::plane(4, 2, 0.75, 1);  // start .7
    Play play(ground, params);
    sim::fill_borders(play.state, params);
    sim::bcre::lower_slope(play.state, (*play.engine.scratch), 0, 5);
    sim::bcre::yield(play.state, params, (*play.engine.scratch), 0, 5);
    EXPECT_NEAR(play.state.rolling(2, 2), params.start_depth, 1e-5);

    support::Ground gentle = support::plane(4, 2, 0.4, 1);
    gentle.set(gentle.rolling, [](double, double) { return 0.004; });
    for (const float speed : {1.f, 4.f}) {
        Play thin(gentle, params);
        thin.state.velocity_y.fill(speed);
        sim::fill_borders(thin.state, params);
        sim::bcre::lower_slope(thin.state, (*thin.engine.scratch), 0, 5);
        sim::bcre::yield(thin.state, params, (*thin.engine.scratch), 0, 5);
        EXPECT_EQ(thin.state.rolling(2, 2) == 0, speed < params.deposit_speed) << speed;
    }
}

TEST(Yield, holds_natural_ground_that_is_steep_from_the_first) {
    const support::Ground steep = support::plane(20, 2, 1.1, 1);
    Play anchored(steep, lively(Model::kBcreInertial));
    anchored.ticks(60);
    EXPECT_EQ(anchored.state.ledger.rolling, 0);
    sim::Params params = lively(Model::kBcreInertial);
    params.anchor_gain = params.anchor_margin = 0;
    Play loose(steep, params);
    loose.ticks(60);
    EXPECT_GT(loose.state.ledger.rolling, 0);
}

}  // namespace
