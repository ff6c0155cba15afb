#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "sim/bcre/plain.h"
#include "sim/bcre/stages.h"
#include "sim/momentum/plain.h"
#include "sim/momentum/stages.h"
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

// A world of bcre-inertial, 5 by 5 vertices, in which stages run one after the other; their results are in w.
struct Momentum {
    Play play;
    sim::momentum::StageRows<float> w;

    explicit Momentum(const support::Ground& ground, const sim::Params& params = lively(Model::kBcreInertial))
        : play(ground, params, {.plain = true}),
          w(sim::momentum::stage_rows(play.state, play.state.params, play.engine.scratch->momentum(),
                                      kHalfQuantum)) {}

    template <class Stage>
    void each_row(Stage&& stage) {
        for (int y = 0; y < w.ny; ++y) sim::along<float>({0, w.nx}, stage(y));
    }
    void find_forces() {
        for (int y = 0; y < w.ny; ++y) sim::fill_halo<float>(w, w.u0, y, {0, w.nx});
        each_row([&](int y) { return sim::momentum::find_ground<float>(w, w, y); });
        each_row([&](int y) { return sim::momentum::drive<float, true>(w, w, y); });
    }
    // Exchange under a layer that moves at `speed`.
    void exchange_at(float speed) {
        find_forces();
        for (int y = 0; y < w.ny; ++y)
            for (int x = 0; x < w.nx; ++x) w.driven_u[y][x] = 0, w.driven_v[y][x] = speed;
        each_row([&](int y) { return sim::momentum::exchange<float>(w, w, y); });
    }
    // The wanted fluxes along x if only the vertex (x, 2) moves, along y.
    const float* fluxes_beside(int x) {
        find_forces();
        w.fed = w.u0.rolling;
        for (int y = -1; y <= w.ny; ++y)
            for (int i = -1; i <= w.nx; ++i) w.driven_u[y][i] = w.driven_v[y][i] = 0;
        w.driven_v[2][x] = 1;
        for (int y = -1; y <= w.ny; ++y) sim::momentum::end_ground<float>(w, w, y, {0, w.nx});
        each_row([&](int y) { return sim::momentum::reconstruct<float>(w, w, y); });
        for (int y = -1; y <= w.ny; ++y) sim::momentum::end_reconstruct<float>(w, w, y, {0, w.nx});
        each_row([&](int y) { return sim::momentum::find_fluxes_x<float>(w, w, y); });
        return w.flux_x[2];
    }
    // Start and rest, where nothing is transported or exchanged.
    void yield() {
        find_forces();
        for (int y = 0; y < w.ny; ++y)
            for (int x = 0; x < w.nx; ++x) {
                w.exchanged[y][x] = 0;
                w.moved_rolling[y][x] = w.u0.rolling[y][x];
                w.moved_u[y][x] = w.u0.velocity_x[y][x], w.moved_v[y][x] = w.u0.velocity_y[y][x];
            }
        each_row([&](int y) { return sim::momentum::find_quiet<float>(w, w, y); });
        auto moved = w.moved();
        for (int y = 0; y < w.ny; ++y) sim::fill_halo<float>(w, moved, y, {0, w.nx});
        for (int y = -1; y <= w.ny; ++y) sim::momentum::end_quiet<float>(w, w, y, {0, w.nx});
        each_row([&](int y) { return sim::momentum::yield<float>(w, w.u0, y, w.nx); });
    }
};

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

TEST(Forces, of_a_thin_layer_have_the_friction_of_its_thickness) {
    for (const double rolling : {0.1, 0.5}) {
        support::Ground ground = support::plane(4, 2, 0.75, 1);
        ground.set(ground.rolling, [&](double, double) { return rolling; });
        Momentum momentum(ground);
        momentum.find_forces();
        const double cos = 0.8, sin = 0.6, friction = 0.36 + 0.39 * std::exp(-rolling * cos / 0.1);
        EXPECT_NEAR(momentum.w.driven_v[2][2], 9.81 * (sin - friction * cos) * cos * 0.02, 1e-6) << rolling;
        EXPECT_EQ(momentum.w.held[2][2], 0);
    }
}

TEST(Forces, hold_a_film_that_is_thin_enough) {
    support::Ground ground = support::plane(4, 2, 0.5, 1);
    const double holds = 0.1 * std::log(0.39 / 0.14) * std::hypot(1, 0.5);
    for (const double part : {0.99, 1.01}) {
        ground.set(ground.rolling, [&](double, double) { return part * holds; });
        Momentum momentum(ground);
        momentum.find_forces();
        EXPECT_EQ(momentum.w.driven_v[2][2] > 0, part > 1);
        EXPECT_EQ(momentum.w.held[2][2], part > 1 ? 0.f : 1.f);
    }
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

sim::Params levelled() {
    sim::Params params = lively(Model::kBcreInertial);
    params.levelling = 1;
    return params;
}

// A level layer of 1 m, in which the vertex in the middle stands higher: J = −rise, h the mean of both sides. A rise of
// ½ μ Δx = .36 m is held.
TEST(Levelling, takes_down_a_vertex_that_moves_and_one_that_is_held_only_if_it_is_steep) {
    constexpr double kCourant = 0.02 / 2, kHeld = 0.5 * 0.36 * 2;
    const auto flux = [](double rise, int moving) {
        support::Ground ground({5, 5, 2});
        ground.set(ground.rolling, [&](double x, double y) { return x == 4 && y == 4 ? 1 + rise : 1; });
        return static_cast<double>(Momentum(ground, levelled()).fluxes_beside(moving)[3]);
    };
    for (const double rise : {0.1, 0.3, 0.5}) {
        const double levels = kCourant * (1 + rise) * 0.5 * std::sqrt(9.81 / (1 + rise / 2)) * rise;
        EXPECT_NEAR(flux(rise, 2), levels, 1e-6) << rise;
        EXPECT_NEAR(flux(rise, 3), rise > kHeld ? levels : 0, 1e-6) << rise;
        EXPECT_EQ(flux(rise, 0), 0) << rise;
        // A hole is filled by what moves beside it.
        EXPECT_NEAR(flux(-rise, 3), -kCourant * 0.5 * std::sqrt(9.81 / (1 - rise / 2)) * rise, 1e-6) << rise;
        EXPECT_EQ(flux(-rise, 2) < 0, rise > kHeld) << rise;
    }
}

// The higher side gives at most what it has: a bare step of bedrock presses nothing.
TEST(Levelling, is_not_driven_by_bare_ground) {
    support::Ground ground({5, 5, 2});
    ground.set(ground.bedrock, [](double x, double) { return x > 4 ? 3 : 0; });
    ground.set(ground.rolling, [](double x, double) { return x > 4 ? 0 : 1; });
    EXPECT_EQ(Momentum(ground, levelled()).fluxes_beside(2)[3], 0);
    ground.set(ground.rolling, [](double x, double) { return x > 4 ? 0.25 : 1; });
    Momentum momentum(ground, levelled());
    const double flux = momentum.fluxes_beside(2)[3];
    const double cos = std::sqrt(momentum.w.cosine[2][2] * momentum.w.cosine[2][3]);
    EXPECT_NEAR(flux, -0.02 / 2 * 0.25 * 0.5 * std::sqrt(9.81 / 0.625) * cos * 0.25, 1e-6);
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

TEST(MomentumExchange, deposits_nothing_above_the_deposit_speed) {
    for (const float speed : {2.f, 3.f}) {  // the gate is at 2.5 m/s
        support::Ground ground = support::plane(4, 2, 0.1, 1);
        ground.set(ground.rolling, [](double, double) { return 0.5; });
        Momentum momentum(ground);
        momentum.exchange_at(speed);
        const double friction = 0.36 + 0.39 * std::exp(-5 / std::hypot(1, 0.1));
        EXPECT_NEAR(momentum.w.exchanged[2][2],
                    -2 * 0.5 * (friction - 0.1) * std::max(0., 1 - speed / 2.5) * 0.02, 1e-5);
        EXPECT_EQ(momentum.w.driven_v[2][2], speed);  // what stays moving keeps its speed
    }
}

TEST(MomentumExchange, erodes_by_its_way_from_the_erosion_depth_on_and_from_rest) {
    for (const double rolling : {0.04, 0.06, 0.5}) {
        support::Ground ground = support::plane(4, 2, 0.9, 1);
        ground.set(ground.rolling, [&](double, double) { return rolling; });
        Momentum momentum(ground);
        momentum.exchange_at(4);
        const double above = std::max(0., rolling - 0.05);
        const double eroded = 0.3 * 4 * 0.02 * 0.35 * above / rolling;
        EXPECT_NEAR(momentum.w.exchanged[2][2], eroded, 1e-5) << rolling;
        EXPECT_EQ(momentum.w.fed[2][2], momentum.w.u0.rolling[2][2] + momentum.w.exchanged[2][2]);
        EXPECT_NEAR(momentum.w.fed[2][2] * momentum.w.driven_v[2][2], rolling * 4, 1e-4) << rolling;
    }
}

TEST(MomentumExchange, takes_no_more_than_lies_there) {
    support::Ground ground = support::plane(4, 2, 0.9, 0.001);
    ground.set(ground.rolling, [](double, double) { return 0.5; });
    Momentum momentum(ground);
    momentum.exchange_at(40);
    EXPECT_EQ(momentum.w.exchanged[2][2], sim::nearest_quanta(0.001f));
}

TEST(Yield, starts_above_the_start_slope) {
    sim::Params params = lively(Model::kBcreInertial);
    params.anchor_gain = params.anchor_margin = params.anchor_step = 0;
    for (const double tangent : {0.69, 0.71}) {  // start .7
        Momentum momentum(support::plane(4, 2, tangent, 1), params);
        momentum.yield();
        EXPECT_NEAR(momentum.play.state.rolling(2, 2), tangent > 0.7 ? params.start_depth : 0, 1e-5);
    }
}

TEST(Yield, starts_nothing_that_friction_would_hold) {
    sim::Params params = lively(Model::kBcreInertial);
    params.anchor_gain = params.anchor_margin = params.anchor_step = 0;
    Momentum momentum(support::plane(4, 2, 0.71, 0.004), params);  // a film, whose friction is .73
    momentum.play.state.params.freeze_depth = 0.001f;
    momentum.w.c.freeze_depth = 0.001f;
    momentum.yield();
    EXPECT_EQ(momentum.play.state.rolling(2, 2), 0);
}

TEST(Yield, freezes_a_thin_layer_only_among_quiet_neighbours) {
    support::Ground ground = support::plane(4, 2, 0.4, 1);
    ground.set(ground.rolling, [](double, double) { return 0.004; });
    for (const bool flows : {false, true}) {
        if (flows) ground.rolling[ground.at(1, 2)] = 0.5f;
        Momentum momentum(ground);
        momentum.play.state.velocity_y.fill(1);
        momentum.yield();
        EXPECT_EQ(momentum.play.state.rolling(2, 2) == 0, !flows);
        EXPECT_EQ(momentum.play.state.velocity_y(2, 2), flows ? 1.f : 0.f);
        EXPECT_EQ(momentum.play.state.rolling(3, 2), 0);  // its neighbours are thin too
    }
}

TEST(Yield, freezes_a_deep_layer_that_is_held_and_slow) {
    support::Ground ground = support::plane(4, 2, 0.3, 1);  // friction .36
    ground.set(ground.rolling, [](double, double) { return 0.5; });
    for (const float speed : {0.1f, 0.3f}) {
        Momentum momentum(ground);
        momentum.play.state.velocity_y.fill(speed);
        momentum.yield();
        EXPECT_EQ(momentum.play.state.rolling(2, 2) == 0, speed < sim::momentum::kNearlyAtRest) << speed;
    }
}

TEST(Yield, starts_loose_material_above_the_loose_slope_but_not_natural_ground) {
    for (const double tangent : {0.5, 0.6}) {  // loose .55, start .7
        Momentum momentum(support::plane(4, 2, tangent, 1));
        sim::State& state = momentum.play.state;
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 5; ++x) state.depth(x, y) += 0.125f;
        momentum.yield();
        EXPECT_EQ(state.rolling(2, 2), tangent > 0.55 ? 0.125f : 0.f);
        EXPECT_EQ(state.depth(2, 2), tangent > 0.55 ? 1.f : 1.125f);
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
