#include "sim/step.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "sim/world/snapshot.h"
#include "sim/world/state_hash.h"
#include "tests/support/worlds.h"

namespace {

using sim::Model;
using sim::Scheme;
using support::kPhysics;
using support::lively;
using support::Physics;
using support::Play;

// Commands of all kinds, in and around the world.
std::vector<sim::Command> any_commands(std::mt19937& random, double extent) {
    const auto within = [&](double least, double most) {
        return least + (most - least) * static_cast<double>(random()) / 4294967296.0;
    };
    std::vector<sim::Command> commands;
    for (const sim::CommandInfo& info : sim::kCommands) {
        if (info.has_param) continue;  // any_number, below
        sim::Command c;
        c.kind = info.kind;
        if (sim::is_of_weather(c)) continue;  // tests/sim/weather.cpp
        c.x = within(-0.2, 1.2) * extent;
        c.y = within(-0.2, 1.2) * extent;
        c.radius = within(0, 0.3) * extent;
        c.rate = c.kind == sim::CommandKind::kPour ? within(0, 200) : within(0, 2);
        c.duration = within(0, 0.5);
        c.depth = within(0, 2);
        c.layer = random() % 2 ? sim::Layer::kRolling : sim::Layer::kStanding;
        c.profile = random() % 2 ? sim::Profile::kDisc : sim::Profile::kCone;
        commands.push_back(support::of_its_kind(c));
    }
    return commands;
}

// Sets a random parameter anywhere in its range, while the thresholds keep their order.
sim::Command any_number(std::mt19937& random, const sim::Params& now) {
    for (;;) {
        sim::Command set;
        set.kind = sim::CommandKind::kSet;
        set.param = random() % std::size(sim::kParams);
        const sim::ParamInfo& info = sim::kParams[set.param];
        const double least = static_cast<double>(info.least), most = static_cast<double>(info.most);
        set.value = least * std::pow(std::max(most, 1e-3) / std::max(least, 1e-3),
                                     static_cast<double>(random()) / 4294967296.0);
        if (!info.fixed && !sim::fault_of(set) && !sim::fault_after(now, {&set, 1})) return set;
    }
}

TEST(Step, keeps_a_pile_between_its_thresholds_bit_identical) {
    for (const Physics& p : kPhysics) {
        Play play(support::pile(40, 1, 0.55, 6), lively(p.model, p.scheme));  // stop .5, start .7
        const sim::Field<float> before = play.state.depth;
        play.ticks(300);
        EXPECT_TRUE(support::same_bits(before, play.state.depth)) << p.name();
        EXPECT_EQ(play.state.ledger.rolling, 0) << p.name();
    }
}

TEST(Step, slides_a_pile_above_its_start_slope_to_rest_near_the_stop_slope) {
    for (const Physics& p : {kPhysics[1], kPhysics[2], kPhysics[3]}) {
        sim::Params params = lively(p.model, p.scheme);
        params.anchor_gain = params.anchor_margin = params.anchor_step = 0;  // a heap, not natural ground
        Play play(support::pile(60, 1, 0.9, 9), params);
        const float top = play.state.depth(30, 30);
        for (int second = 0; second < 120 && (second == 0 || !sim::at_rest(play.state)); ++second)
            play.ticks(60);
        EXPECT_TRUE(sim::at_rest(play.state)) << p.name();
        // Central differences see no slope at the very tip, so that forces leave it standing.
        const int beside = sim::has_momentum(p.model) ? 1 : 0;
        EXPECT_LT(play.state.depth(30 + beside, 30), top - 1) << p.name();
        // From 10 m to 4 m beside the middle no side is steeper than the start slope, nor is all of it much
        // gentler than the stop slope.
        const float fall = play.state.depth(34, 30) - play.state.depth(40, 30);
        EXPECT_GT(fall / 6, 0.2f) << p.name();
        EXPECT_LT(fall / 6, params.start_slope) << p.name();
    }
}

TEST(Step, conserves_mass_to_the_quantum_under_any_commands) {
    for (const Physics& p : kPhysics)
        for (const auto border : {sim::Border::kWall, sim::Border::kOpen, sim::Border::kSink}) {
            sim::Params params = lively(p.model, p.scheme);
            params.borders = {border, sim::Border::kOpen, border, sim::Border::kSink};
            support::Ground ground = support::rough(24, 2, 7);
            for (int x = 5; x < 9; ++x) ground.has_data[ground.at(x, 12)] = 0;
            Play play(ground, params);
            std::mt19937 random(1);
            for (int tick = 0; tick < 1200; ++tick) {
                play.ticks(1, tick % 20 == 0 ? any_commands(random, 48) : std::vector<sim::Command>{});
                ASSERT_EQ(play.state.ledger.mass_error(), 0) << p.name() << ", tick " << tick;
            }
            EXPECT_GT(play.state.ledger.poured, 0);
            EXPECT_GT(play.state.ledger.dug, 0);
            EXPECT_GT(play.state.ledger.out, 0);
        }
}

TEST(Step, stays_finite_and_conserves_mass_with_any_parameters_in_range) {
    for (const Physics& p : kPhysics) {
        Play play(support::rough(16, 2, 11), lively(p.model, p.scheme));
        std::mt19937 random(3);
        for (int tick = 0; tick < 300; ++tick) {
            std::vector<sim::Command> commands;
            if (tick % 5 == 0) commands = any_commands(random, 32);
            commands.push_back(any_number(random, play.state.params));
            if (sim::fault_after(play.state.params, commands)) continue;
            play.ticks(1, commands);
            ASSERT_EQ(play.state.ledger.mass_error(), 0) << p.name() << ", tick " << tick;
            for (int y = 0; y < play.state.grid.ny; ++y)
                for (int x = 0; x < play.state.grid.nx; ++x) {
                    ASSERT_GE(play.state.depth(x, y), 0) << p.name() << ", tick " << tick;
                    ASSERT_GE(play.state.rolling(x, y), 0) << p.name() << ", tick " << tick;
                    ASSERT_TRUE(std::isfinite(play.state.velocity_x(x, y)) &&
                                std::isfinite(play.state.velocity_y(x, y)))
                        << p.name() << ", tick " << tick;
                }
        }
    }
}

TEST(Step, never_makes_a_depth_negative_or_a_speed_too_high) {
    for (const Physics& p : kPhysics) {
        Play play(support::rough(24, 2, 3), lively(p.model, p.scheme));
        const float fastest =
            sim::has_momentum(p.model) ? play.state.params.greatest_speed : play.state.params.max_speed;
        std::mt19937 random(5);
        for (int tick = 0; tick < 600; ++tick) {
            play.ticks(1, tick % 10 == 0 ? any_commands(random, 48) : std::vector<sim::Command>{});
            for (int y = 0; y < play.state.grid.ny; ++y)
                for (int x = 0; x < play.state.grid.nx; ++x) {
                    ASSERT_GE(play.state.depth(x, y), 0) << p.name() << ", tick " << tick;
                    ASSERT_GE(play.state.rolling(x, y), 0) << p.name() << ", tick " << tick;
                    const float speed = std::hypot(play.state.velocity_x(x, y), play.state.velocity_y(x, y));
                    ASSERT_LE(speed, fastest * 1.001f) << p.name() << ", tick " << tick;
                    ASSERT_TRUE(play.state.rolling(x, y) > 0 || speed == 0) << p.name() << ", tick " << tick;
                }
        }
    }
}

TEST(Step, is_bit_identical_with_any_number_of_threads) {
    for (const Physics& p : kPhysics) {
        Play one(support::rough(40, 2, 11), lively(p.model, p.scheme));
        one.ticks(200);
        for (const int threads : {2, 3, 5, 8}) {
            Play many(support::rough(40, 2, 11), lively(p.model, p.scheme), {.threads = threads});
            many.ticks(200);
            EXPECT_EQ(sim::state_hash(one.state), sim::state_hash(many.state)) << p.name() << ", " << threads;
        }
    }
}

TEST(Step, continues_bit_identically_from_a_snapshot) {
    Play play(support::rough(30, 2, 2), lively(Model::kBcreInertial));
    const sim::Command pour = support::pour_at(30, 10, 6, 40, 2);
    play.ticks(30, {&pour, 1});  // taken while a source runs
    const sim::Snapshot snapshot = sim::take_snapshot(play.state);
    play.ticks(200);
    const std::uint64_t straight = sim::state_hash(play.state);
    sim::restore(snapshot, play.state);
    ASSERT_NE(sim::state_hash(play.state), straight);
    play.ticks(200);
    EXPECT_EQ(sim::state_hash(play.state), straight);
}

TEST(Step, brings_a_layer_to_its_terminal_speed_on_a_plane) {
    sim::Params params = lively(Model::kBcreInertial);
    params.drag = 50;
    params.erosion_slope = 5;  // nothing erodes
    support::Ground ground = support::plane(60, 2, 0.6);
    ground.set(ground.rolling, [](double, double) { return 0.5; });
    Play play(ground, params);
    play.ticks(60 * 3);
    const double cos = 1 / std::hypot(1, 0.6), thick = 0.5 * cos;
    const double friction = 0.36 + 0.39 * std::exp(-thick / 0.1);
    const double along_slope = std::sqrt(50 * thick * cos * (0.6 - friction)), expected = along_slope * cos;
    EXPECT_NEAR(play.state.velocity_y(30, 40), expected, 0.01 * expected);  // falls to the north
    EXPECT_NEAR(play.state.velocity_x(30, 40), 0, 1e-3);
}

TEST(Step, spreads_a_resting_layer_with_lax_friedrichs_and_not_with_the_local_scheme) {
    for (const Scheme scheme : {Scheme::kLaxFriedrichs, Scheme::kLocalLaxFriedrichs}) {
        sim::Params params = lively(Model::kBcre, scheme);
        params.exchange_rate = 0;
        params.freeze_depth = 1e-5f;
        support::Ground ground = support::plane(20, 1, 0);
        ground.rolling[ground.at(10, 10)] = 1;
        Play play(ground, params);
        play.ticks(1);
        if (scheme == Scheme::kLaxFriedrichs)
            // one of four neighbours
            EXPECT_NEAR(play.state.rolling(11, 10) + play.state.depth(11, 10), 0.25f, 1e-4f);
        else
            EXPECT_EQ(play.state.rolling(11, 10) + play.state.depth(11, 10), 0);
    }
}

TEST(Step, transports_a_film_whose_flux_is_less_than_a_quantum_per_step) {
    sim::Params params = lively(Model::kBcre);
    params.rolling_speed = 0.5f;
    params.exchange_rate = 0;
    params.freeze_depth = 1e-5f;
    support::Ground ground = support::plane(20, 30, 0.6);
    ground.set(ground.rolling, [](double, double y) { return y == 30 * 5 ? 0.005 : 0.0; });
    Play play(ground, params);
    const double flux = 0.005 * 0.5 / 30 / 60;  // m per tick
    ASSERT_LT(flux, static_cast<double>(sim::kQuantum) / 2);
    play.ticks(6000);
    // On arrival it is thinner than the freeze depth and joins the standing layer. Meanwhile the donor
    // empties.
    const double arrived = static_cast<double>(play.state.rolling(10, 6) + play.state.depth(10, 6));
    EXPECT_NEAR(arrived, 0.005 * (1 - std::exp(-0.5 * 100 / 30)), 1e-4);
}

TEST(Borders, wall_keeps_material_in_and_open_and_sink_let_it_out) {
    for (const Physics& p : kPhysics)
        for (const auto border : {sim::Border::kWall, sim::Border::kOpen, sim::Border::kSink}) {
            sim::Params params = lively(p.model, p.scheme);
            params.borders.fill(border);
            support::Ground ground = support::plane(20, 2, 0.8);
            ground.set(ground.rolling, [](double, double) { return 0.3; });
            Play play(ground, params);
            play.ticks(600);
            if (border == sim::Border::kWall)
                EXPECT_EQ(play.state.ledger.out, 0) << p.name();
            else
                EXPECT_GT(play.state.ledger.out, play.state.ledger.initial / 2) << p.name();
        }
}

TEST(Borders, no_data_removes_material_that_reaches_it) {
    sim::Params params = lively(Model::kBcreInertial);
    params.borders.fill(sim::Border::kWall);
    support::Ground ground = support::plane(20, 2, 0.8);
    ground.set(ground.rolling, [](double, double y) { return y < 10 ? 0.3 : 0.0; });
    for (int x = 0; x <= 20; ++x) ground.has_data[ground.at(x, 12)] = 0;
    Play play(ground, params);
    play.ticks(60 * 30);
    EXPECT_GT(play.state.ledger.out, 0);
    for (int x = 0; x <= 20; ++x) {
        EXPECT_EQ(play.state.rolling(x, 12), 0);
        EXPECT_EQ(play.state.depth(x, 14) + play.state.rolling(x, 14), 0);  // nothing passes
    }
}

}  // namespace
