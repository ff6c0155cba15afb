#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "sim/bcre/plain.h"
#include "sim/bcre/stages.h"
#include "sim/inertial/plain.h"
#include "sim/inertial/stages.h"
#include "sim/world/quanta.h"
#include "tests/support/worlds.h"

// Each stage against one cell computed by hand.

namespace {

using sim::Model;
using support::lively;
using support::Play;

constexpr sim::Substep<float> kHalfQuantum{0.02f, 0.5f};  // rounds to nearest

// Runs a sub-step of `bcre` on a world; the results of its stages are in scratch.
struct Stages {
    Play play;
    sim::Scratch<float>& scratch;
    sim::Scratch<float>::Bcre& fields;
    sim::bcre::RkState<sim::Field<float>>& u0;
    sim::Workers& workers;

    Stages(const support::Ground& ground, const sim::Params& params)
        : play(ground, params, {.plain = true}),
          scratch(*play.engine.scratch),
          fields(scratch.bcre()),
          u0(fields.u0),
          workers(play.engine.workers) {}

    void substep(sim::Substep<float> sub = kHalfQuantum) {
        sim::bcre::substep(play.state, play.state.params, fields, scratch.context, workers, sub);
    }
    void find_velocity() {
        sim::bcre::find_velocity(play.state, play.state.params, fields, scratch.context, workers);
    }
};

// The rows of a world of bcre-inertial that steps plainly, its halo filled.
sim::inertial::StageRows<float> stage_rows_of(Play& play) {
    auto w = sim::inertial::stage_rows(play.state, play.state.params, play.engine.scratch->inertial(),
                                       kHalfQuantum);
    for (int y = 0; y < w.ny; ++y) {
        sim::fill_halo<float>(w, w.u0, y, {0, w.nx});
        sim::inertial::end_velocity<float>(w, w.u0, y, {0, w.nx});
    }
    return w;
}

// A flux in whole quanta differs from the exact one by less than one quantum.
constexpr double kRounded = 8e-6;

TEST(Velocity, of_law_C_has_one_speed_down_the_slope) {
    support::Ground ground({5, 5, 2});
    ground.set(ground.bedrock, [](double x, double y) { return -0.3 * x + 0.4 * y; });
    ground.set(ground.rolling, [](double, double) { return 0.1; });
    Stages stages(ground, lively(Model::kBcre));
    stages.find_velocity();
    EXPECT_NEAR(stages.play.state.velocity_x(2, 2), 5 * 0.6, 1e-5);  // V = 5 m/s, down is (0.6, −0.8)
    EXPECT_NEAR(stages.play.state.velocity_y(2, 2), 5 * -0.8, 1e-5);
}

TEST(Velocity, of_bcre_is_zero_without_a_rolling_layer) {
    Stages stages(support::plane(4, 2, 0.5, 1), lively(Model::kBcre));
    stages.find_velocity();
    EXPECT_EQ(stages.play.state.velocity_y(2, 2), 0);
}

TEST(Velocity, of_the_laws_slope_and_shear_grows_up_to_the_greatest) {
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

TEST(Velocity, of_the_inertial_model_relaxes_toward_the_terminal_one_for_half_a_sub_step) {
    support::Ground ground({5, 5, 2});
    ground.set(ground.bedrock, [](double x, double y) { return -0.3 * x + 0.4 * y; });
    ground.set(ground.rolling, [](double, double) { return 0.3; });
    Play play(ground, lively(Model::kBcreInertial), {.plain = true});
    play.state.velocity_x(2, 2) = 1;
    auto w = stage_rows_of(play);
    sim::along<float>({0, 5}, sim::inertial::relax<float>(w, w.u0, w.u0, 2, 5));
    const double terminal = 15 * 0.5 * (0.3 / (0.3 + 0.1));  // k_v |∇z| R/(R + R_h)
    const double gained = 1 - std::exp(-0.01 / 1.5);
    EXPECT_NEAR(play.state.velocity_x(2, 2), 1 + gained * (0.6 * terminal - 1), 1e-5);
    EXPECT_NEAR(play.state.velocity_y(2, 2), gained * -0.8 * terminal, 1e-5);
}

TEST(Fluxes, of_local_lax_friedrichs_go_to_the_lower_neighbours_by_their_drops) {
    support::Ground ground({5, 5, 2});
    ground.set(ground.bedrock, [](double x, double y) { return -0.3 * x + 0.4 * y; });
    ground.rolling[ground.at(2, 2)] = 0.4f;
    Stages stages(ground, lively(Model::kBcre));
    stages.substep();
    EXPECT_NEAR(stages.fields.flux_x(3, 2), 0.4 * 5 * 0.6 * 0.01, kRounded);   // R v_E Δt/Δx
    EXPECT_NEAR(stages.fields.flux_y(2, 2), -0.4 * 5 * 0.8 * 0.01, kRounded);  // south
    EXPECT_EQ(stages.fields.flux_x(2, 2), 0);
    EXPECT_EQ(stages.fields.flux_y(2, 3), 0);
}

TEST(Fluxes, of_a_ridge_go_to_both_sides) {
    support::Ground ground({5, 5, 2});
    ground.set(ground.bedrock, [](double x, double) { return -std::fabs(x - 4); });
    ground.rolling[ground.at(2, 2)] = 0.4f;
    Stages stages(ground, lively(Model::kBcre));
    stages.substep();
    EXPECT_NEAR(stages.fields.flux_x(3, 2), 0.4 * 5 * 0.01, kRounded);
    EXPECT_EQ(stages.fields.flux_x(3, 2), -stages.fields.flux_x(2, 2));
}

TEST(Fluxes, of_lax_friedrichs_are_quarters_and_more_of_them_downhill) {
    support::Ground ground({5, 5, 2});
    ground.set(ground.bedrock, [](double x, double) { return -0.5 * x; });
    ground.rolling[ground.at(2, 2)] = 0.4f;
    Stages stages(ground, lively(Model::kBcre, sim::Scheme::kLaxFriedrichs));
    stages.substep();
    const double quarter = 0.25 * 0.4, half = 0.5 * 0.4 * 5 * 0.01;
    EXPECT_NEAR(stages.fields.flux_x(3, 2), quarter + half, 2 * kRounded);
    EXPECT_NEAR(stages.fields.flux_x(2, 2), -(quarter - half), 2 * kRounded);
    EXPECT_NEAR(stages.fields.flux_y(2, 3), quarter, 2 * kRounded);
}

TEST(Fluxes, of_muscl_take_layer_and_velocity_at_the_face) {
    support::Ground ground({7, 5, 2});
    const float depths[] = {0, 0.1f, 0.3f, 0.4f, 0.6f, 0.6f, 0};
    for (int x = 0; x < 7; ++x) ground.rolling[ground.at(x, 2)] = depths[x];
    Stages stages(ground, lively(Model::kBcre, sim::Scheme::kMuscl));
    auto w = sim::bcre::stage_rows(stages.play.state, stages.play.state.params, stages.fields, kHalfQuantum);
    for (int y = 0; y < 5; ++y) sim::fill_halo<float>(w, w.u0, y, {0, 7});
    for (int x = 0; x < 7; ++x) stages.u0.velocity_x(x, 2) = x == 3 ? 4 : 2;
    sim::along<float>(
        {0, 8}, sim::bcre::find_muscl_fluxes<float, sim::bcre::RkStage::kFirst>(w, w.flux_x, w.flux_y, 2));
    EXPECT_NEAR(stages.fields.flux_x(3, 2), 3 * 0.01 * (0.3 + 0.05), 1e-7);  // minmod(.2, .1) = .1
    EXPECT_NEAR(stages.fields.flux_x(6, 2), 2 * 0.01 * 0.6, 1e-7);           // a maximum keeps its own
    EXPECT_EQ(stages.fields.flux_y(2, 2), 0);
}

TEST(Fluxes, of_muscl_are_at_most_the_bound_from_the_layers) {
    constexpr int kSide = 12;
    constexpr sim::Span kAll{0, kSide};
    std::mt19937 random(5);
    const auto portion = [&] { return static_cast<float>(random() % 1001) * 1e-3f; };
    Stages stages(support::plane(kSide - 1, 2, 0.1), lively(Model::kBcre, sim::Scheme::kMuscl));
    auto w = sim::bcre::stage_rows(stages.play.state, stages.play.state.params, stages.fields, kHalfQuantum);
    float most = 0;
    for (int round = 0; round < 500; ++round) {
        for (auto* level : {&w.u0, &w.u1})
            for (int y = 0; y < kSide; ++y) {
                for (int x = 0; x < kSide; ++x) {
                    level->rolling[y][x] = random() % 3 ? portion() : 0;
                    const float speed = w.c.rolling_speed * (random() % 3 ? 1 : portion()),
                                turn = 6.2832f * portion();
                    level->velocity_x[y][x] = speed * std::cos(turn);
                    level->velocity_y[y][x] = speed * std::sin(turn);
                }
                sim::fill_halo<float>(w, *level, y, kAll);
                sim::bcre::end_velocity<float>(w, level->velocity_x, y);
            }
        for (int y = 0; y <= kSide; ++y)
            sim::along<float>(
                kAll.faces(),
                sim::bcre::find_muscl_fluxes<float, sim::bcre::RkStage::kFirst>(w, w.flux_x, w.flux_y, y),
                sim::bcre::find_muscl_fluxes<float, sim::bcre::RkStage::kSecond>(w, w.flux_x, w.flux_y, y));
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                const float all = sim::bcre::sum_outward<float>(w.flux_x[y], w.flux_y[y], w.flux_y[y + 1], x);
                const float bound = sim::bcre::greatest_outflow(w.u0.rolling[y][x], w.u1.rolling[y][x], w.c);
                ASSERT_LE(all, bound);
                if (bound > 0) most = std::max(most, all / bound);
            }
    }
    EXPECT_GT(most, 0.7f);  // the bound is not far from what can occur
}

TEST(Fluxes, never_take_more_than_a_vertex_has) {
    std::mt19937 random(3);
    for (const auto scheme :
         {sim::Scheme::kLaxFriedrichs, sim::Scheme::kLocalLaxFriedrichs, sim::Scheme::kMuscl}) {
        support::Ground ground = support::rough(20, 1, 9);
        // Include films of a few quanta, on peaks and in pits, at the greatest Courant number.
        ground.set(ground.rolling, [&](double, double) {
            return random() % 2 ? static_cast<double>(random() % 40) * static_cast<double>(sim::kQuantum)
                                : static_cast<double>(random() % 1000) * 1e-3;
        });
        sim::Params params = lively(Model::kBcre, scheme);
        params.rolling_speed = 25;  // half a cell per sub-step
        params.exchange_rate = 0;
        params.start_slope = 10;
        params.freeze_depth = 0;
        for (int round = 0; round < 50; ++round) {
            Stages stages(ground, params);
            sim::State& state = stages.play.state;
            const auto volume = [&] {  // whole quanta: sums in double are exact
                double sum = 0;
                for (int y = 0; y < 23; ++y)
                    for (int x = 0; x < 21; ++x) sum += static_cast<double>(state.rolling(x, y));
                return sum;
            };
            const double before = volume();
            stages.substep({0.02f, sim::dither_of(round)});
            for (int y = 0; y < 23; ++y)
                for (int x = 0; x < 21; ++x) ASSERT_GE(state.rolling(x, y), 0) << sim::to_string(scheme);
            const auto out = static_cast<double>(sim::drained(stages.scratch));
            ASSERT_EQ(before, volume() + out * static_cast<double>(sim::kQuantum)) << sim::to_string(scheme);
        }
    }
}

TEST(LowerSlope, uses_only_lower_neighbours_and_sees_a_checkerboard) {
    support::Ground ground({5, 5, 2});
    ground.bedrock[ground.at(2, 2)] = 1;
    Stages stages(ground, lively(Model::kBcre));
    stages.substep();
    EXPECT_NEAR(stages.u0.slope_dx(2, 2), std::sqrt(2.0), 1e-6);
    EXPECT_EQ(stages.u0.slope_dx(1, 2), 0);  // beside it only a higher one
}

TEST(Exchange, grows_and_decays_exponentially) {
    support::Ground ground = support::plane(6, 2, 0.8, 3);
    ground.set(ground.rolling, [](double, double) { return 0.05; });
    Stages stages(ground, lively(Model::kBcre));
    stages.substep();
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
        params.rolling_speed = 0;
        Stages stages(ground, params);
        stages.substep();
        const float before = stages.u0.slope_dx(1, 1) - params.stop_slope;
        stages.substep();  // for the slope as the first has left it
        const float after = stages.u0.slope_dx(1, 1) - params.stop_slope;
        const float slack = 2e-5f;  // a quantum and float32
        if (before > 0) {
            ASSERT_GE(after, -slack) << round;
        } else {
            ASSERT_LE(after, slack) << round;
        }
    }
}

// Of row 2.
void find_fluxes(sim::inertial::StageRows<float>& w) {
    for (int y = 1; y <= 3; ++y) {
        sim::along<float>({0, w.nx}, sim::inertial::find_slopes<float>(w.u0, w.u0, y));
        sim::inertial::end_slopes<float>(w, w.u0, y, {0, w.nx});
    }
    sim::along<float>({0, w.nx + 1}, sim::inertial::find_fluxes_x<float>(w, w.u0, w.u0, 2),
                      sim::inertial::find_fluxes_y<float>(w, w.u0, w.u0, 2));
}

TEST(InertialTransport, takes_layer_and_momentum_at_the_face) {
    support::Ground ground({7, 5, 2});
    const float depths[] = {0, 0.1f, 0.3f, 0.4f, 0.6f, 0.6f, 0}, speeds[] = {0, 1, 2, 4, 4, 4, 0};
    for (int x = 0; x < 7; ++x) ground.rolling[ground.at(x, 2)] = depths[x];
    Play play(ground, lively(Model::kBcreInertial), {.plain = true});
    for (int x = 0; x < 7; ++x) play.state.velocity_x(x, 2) = speeds[x];
    auto w = stage_rows_of(play);
    find_fluxes(w);
    // Between 0.3 m at 2 m/s and 0.4 m at 4: the slopes of R are 0.15 and 0.15, those of u 1.5 and 0.
    const double left = 0.3 + 0.075, right = 0.4 - 0.075, joint = (left * 2.75 + right * 4) / (left + right);
    const double flux = left * joint * 0.02 / 2;
    EXPECT_NEAR(w.u0.flux_x[2][3], flux, 1e-6);
    EXPECT_NEAR(w.u0.momentum_xu[2][3], flux * 2.75, 2e-6);
    EXPECT_EQ(w.u0.momentum_xv[2][3], 0);
    EXPECT_EQ(w.u0.flux_x[2][1], 0);  // what is empty gives nothing
    EXPECT_EQ(w.u0.flux_y[2][2], 0);
}

TEST(InertialTransport, takes_a_quarter_of_a_vertex_through_a_face_at_most) {
    support::Ground ground({5, 5, 1});
    ground.rolling[ground.at(2, 2)] = 0.5f;
    Play play(ground, lively(Model::kBcreInertial), {.plain = true});
    play.state.velocity_x(2, 2) = 1000;
    auto w = stage_rows_of(play);
    find_fluxes(w);
    EXPECT_EQ(w.u0.flux_x[2][3], 0.125f);
}

// The slopes of `level`, and what would be exchanged, on all of a world of 5 by 5 vertices.
void find_exchange(const sim::inertial::StageRows<float>& w, sim::inertial::StateRows<float>& u) {
    for (int y = 0; y <= 5; ++y)
        sim::along<float>({0, 6}, sim::find_drops<float>(w, u, u.drop_x, u.drop_y, y)),
            sim::end_drops<float>(w, u.drop_x, y);
    for (int y = 0; y <= 5; ++y)
        sim::along<float>({0, 6}, sim::find_curvature<float>(w, u, u.curvature_x, u.curvature_y, y));
    for (int y = 0; y < 5; ++y)
        sim::along<float>({0, 5}, sim::inertial::find_exchange<float>(w, u, u.exchanged, y));
}

// Runs a stage of the exchange alone on material that moves at `speed`; the result is in scratch.
void exchange_stage(Play& play, float speed) {
    play.state.velocity_y.fill(speed);
    auto w = stage_rows_of(play);
    find_exchange(w, w.u0);
    for (int y = 0; y < 5; ++y) sim::along<float>({0, 5}, sim::inertial::predict<float>(w, w.u0, w.u1, y));
}

TEST(InertialExchange, deposits_nothing_above_the_deposit_speed) {
    for (const float speed : {2.f, 3.f}) {  // the gate is at 2.5 m/s
        support::Ground ground = support::plane(4, 2, 0.1);
        ground.set(ground.rolling, [](double, double) { return 0.5; });
        Play play(ground, lively(Model::kBcreInertial), {.plain = true});
        exchange_stage(play, speed);
        const double stop = 0.36 + (0.5 - 0.36) * std::exp(-5.);  // of 0.5 m
        EXPECT_NEAR(play.engine.scratch->inertial().u1.depth(2, 2),
                    2 * 0.5 * (stop - 0.1) * std::max(0., 1 - speed / 2.5) * 0.02, 1e-6);
        EXPECT_EQ(play.engine.scratch->inertial().u1.velocity_y(2, 2),
                  speed);  // what stays moving keeps its speed
    }
}

TEST(InertialExchange, does_nothing_between_stop_and_erosion_slope) {
    support::Ground ground = support::plane(4, 2, 0.52, 1);  // stop .5, erosion .55
    ground.set(ground.rolling, [](double, double) { return 0.5; });
    Play play(ground, lively(Model::kBcreInertial), {.plain = true});
    exchange_stage(play, 1);
    EXPECT_EQ(play.engine.scratch->inertial().u1.depth(2, 2), 1);
}

TEST(InertialExchange, erodes_smoothly_from_the_erosion_depth_on_and_from_rest) {
    for (const double rolling : {0.04, 0.06, 0.5}) {
        support::Ground ground = support::plane(4, 2, 0.9, 1);
        ground.set(ground.rolling, [&](double, double) { return rolling; });
        Play play(ground, lively(Model::kBcreInertial), {.plain = true});
        exchange_stage(play, 4);
        const double above = std::max(0., rolling - 0.05), eroded = 2 * above * above / rolling * 0.35 * 0.02;
        EXPECT_NEAR(play.engine.scratch->inertial().u1.rolling(2, 2), rolling + eroded, 1e-5) << rolling;
        EXPECT_NEAR(play.engine.scratch->inertial().u1.rolling(2, 2) *
                        play.engine.scratch->inertial().u1.velocity_y(2, 2),
                    rolling * 4, 1e-4)
            << rolling;
    }
}

// Finds the slopes toward lower neighbours, then yields.
void yield_stage(Play& play) {
    auto w = stage_rows_of(play);
    w.u1.depth = w.u0.depth, w.u1.rolling = w.u0.rolling;  // the slopes of what is
    find_exchange(w, w.u1);
    for (int y = 0; y < 5; ++y) sim::along<float>({0, 5}, sim::inertial::yield<float>(w, w.u0, y, 5));
}

TEST(Yield, starts_above_the_start_slope_and_freezes_thin_slow_layers) {
    sim::Params params = lively(Model::kBcreInertial);
    params.anchor_gain = params.anchor_margin = params.anchor_step = 0;
    Play play(support::plane(4, 2, 0.75, 1), params, {.plain = true});  // start .7
    yield_stage(play);
    EXPECT_NEAR(play.state.rolling(2, 2), params.start_depth, 1e-5);

    support::Ground gentle = support::plane(4, 2, 0.4, 1);
    gentle.set(gentle.rolling, [](double, double) { return 0.004; });
    for (const float speed : {1.f, 4.f}) {
        Play thin(gentle, params, {.plain = true});
        thin.state.velocity_y.fill(speed);
        yield_stage(thin);
        EXPECT_EQ(thin.state.rolling(2, 2) == 0, speed < params.deposit_speed) << speed;
    }
}

TEST(Yield, starts_loose_material_above_the_erosion_slope_but_not_natural_ground) {
    const sim::Params params = lively(Model::kBcreInertial);
    for (const double tangent : {0.5, 0.6}) {  // erosion .55, start .7
        Play play(support::plane(4, 2, tangent, 1), params, {.plain = true});
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 5; ++x) play.state.depth(x, y) += 0.125f;
        yield_stage(play);
        EXPECT_EQ(play.state.rolling(2, 2), tangent > 0.55 ? 0.125f : 0.f);
        EXPECT_EQ(play.state.depth(2, 2), tangent > 0.55 ? 1.f : 1.125f);
    }
}

TEST(Yield, of_bcre_starts_above_the_start_slope_on_any_ground) {
    Stages stages(support::plane(4, 2, 0.75, 1), lively(Model::kBcre));  // start .7
    stages.substep();
    EXPECT_NEAR(stages.play.state.rolling(2, 2), stages.play.state.params.start_depth, 1e-5);
}

TEST(Yield, holds_natural_ground_that_is_initially_steep) {
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
