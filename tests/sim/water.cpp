#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/named_fields.h"
#include "sim/simd/instruction_set.h"
#include "sim/world/snapshot.h"
#include "sim/world/state_hash.h"
#include "sim/world/thing_places.h"
#include "sim/world/things.h"
#include "tests/support/worlds.h"

// Water in the soil: what its commands add and take, and what a slope does with it.

namespace {

using sim::Command;
using sim::CommandKind;
using sim::Model;
using support::Ground;
using support::Play;

constexpr float kSoil = 2000;  // kg/m³, so that saturated soil keeps exactly half of its friction

Command rain(CommandKind kind, double x, double y, double radius, double rate, double duration) {
    Command c = support::pour_at(x, y, radius, rate, duration);
    c.kind = kind;
    return c;
}
Command wet(double x, double y, double radius, double rate, double duration) {
    return rain(CommandKind::kWet, x, y, radius, rate, duration);
}
Command drain(double x, double y, double radius, double rate, double duration) {
    return rain(CommandKind::kDrain, x, y, radius, rate, duration);
}

Ground soil(int squares, float dx, double tangent, double depth) {
    Ground ground = support::plane(squares, dx, tangent, depth);
    ground.density = kSoil;
    return ground;
}

void saturate(sim::State& s, float m) {
    sim::Field<float>& water = sim::things_of(s).water;
    for (int y = 0; y < s.grid.ny; ++y) std::fill(water.row(y), water.row(y) + s.grid.nx, m);
    s.things->unhashed = true;
}

float m_at(const Play& play, int x, int y) {
    return play.state.things ? play.state.things->water(x, y) : 0;
}

// 0.02 m/s for a second on 0.5 m of soil: .02/(.4 · .5) of its depth.
TEST(Water, fills_the_pores_of_the_standing_layer_and_no_more) {
    Play play(soil(20, 5, 0, 0.5), support::lively(Model::kBcreInertial));
    play.state.depth(12, 10) = 1, play.state.depth(13, 10) = 0;
    const Command shower = wet(50, 50, 30, 0.02, 1);
    play.ticks(60, {&shower, 1});
    EXPECT_NEAR(static_cast<double>(m_at(play, 10, 10)), 0.1, 1e-6);
    EXPECT_NEAR(static_cast<double>(m_at(play, 12, 10)), 0.05, 1e-6);
    EXPECT_EQ(m_at(play, 13, 10), 0) << "water runs off bare rock";
    EXPECT_EQ(m_at(play, 17, 10), 0) << "outside of the disc";
    EXPECT_TRUE(play.state.running_commands.empty());
    const Command flood = wet(50, 50, 30, 0.1, 10);
    play.ticks(600, {&flood, 1});
    EXPECT_EQ(m_at(play, 10, 10), 1);
    const Command pump = drain(50, 50, 30, 0.02, 1), pump_all = drain(50, 50, 30, 0.1, 10);
    play.ticks(60, {&pump, 1});
    EXPECT_NEAR(static_cast<double>(m_at(play, 10, 10)), 0.9, 1e-6);
    play.ticks(600, {&pump_all, 1});
    EXPECT_EQ(m_at(play, 10, 10), 0);
    EXPECT_EQ(play.state.ledger.mass_error(), 0);
}

TEST(Water, follows_profile_and_slope_of_its_command) {
    Ground ground = soil(40, 5, 0, 0.5);
    ground.set(ground.bedrock, [](double x, double) { return x < 100 ? 0.0 : 0.5 * (x - 100); });
    Play play(ground, support::lively(Model::kBcreInertial));
    Command shower = wet(100, 100, 50, 0.02, 0);
    shower.profile = sim::Profile::kCone;
    shower.least_slope = 20, shower.most_slope = 40;
    sim::apply_commands(play.state, {&shower, 1});
    const auto whole = static_cast<double>(0.02 / 60 / (0.4 * 0.5));
    EXPECT_NEAR(static_cast<double>(m_at(play, 25, 20)), 0.5 * whole, 1e-6);
    EXPECT_NEAR(static_cast<double>(m_at(play, 28, 20)), 0.2 * whole, 1e-6);
    EXPECT_EQ(m_at(play, 15, 20), 0) << "too flat";
}

// A millimetre in an hour is less in a tick than the digits of a float hold beside 1.
TEST(Water, of_slow_rain_is_not_lost_to_rounding_and_drains_to_nothing) {
    Play play(soil(4, 5, 0, 10), support::lively(Model::kBcreInertial));
    saturate(play.state, 0.75f);
    const Command drizzle = wet(10, 10, 50, 1e-3 / 3600, 60), pump = drain(10, 10, 50, 1e-3 / 3600, 60);
    play.ticks(3600, {&drizzle, 1});
    EXPECT_NEAR(static_cast<double>(m_at(play, 2, 2)) - 0.75, 1e-3 / 60 / (0.4 * 10), 6e-8);
    play.ticks(3600, {&pump, 1});
    EXPECT_EQ(m_at(play, 2, 2), 0.75f);
}

TEST(Water, of_rock_from_which_the_soil_went_dries_at_once) {
    Play play(soil(4, 5, 0, 1), support::lively(Model::kBcreInertial));
    saturate(play.state, 1);
    play.state.depth(2, 2) = 0;
    const Command pump = drain(10, 10, 50, 1e-6, 0);
    sim::apply_commands(play.state, {&pump, 1});
    EXPECT_EQ(m_at(play, 2, 2), 0);
    EXPECT_GT(m_at(play, 1, 1), 0.99f);
}

// Every force, threshold and rate in which friction counts, at once.
TEST(Water, that_saturates_soil_twice_as_heavy_halves_friction_and_slopes_to_the_bit) {
    for (const Model model : {Model::kBcreInertial, Model::kVoellmy}) {
        sim::Params params = support::lively(model), half = params;
        for (float sim::Params::*of_friction :
             {&sim::Params::friction, &sim::Params::friction_thin, &sim::Params::start_slope,
              &sim::Params::loose_slope, &sim::Params::erosion_slope, &sim::Params::anchor_gain,
              &sim::Params::anchor_margin, &sim::Params::anchor_step})
            half.*of_friction *= 0.5f;
        Ground ground = support::rough(40, 5, 6);
        ground.set(ground.bedrock, [](double, double y) { return -0.5 * y; });
        ground.density = kSoil;
        Play saturated(ground, params), dry(ground, half), other(ground, params);
        saturate(saturated.state, 1), saturate(dry.state, 0), saturate(other.state, 0.5f);
        for (int tick = 0; tick < 120; ++tick) {
            saturated.ticks(1), dry.ticks(1), other.ticks(1);
            ASSERT_TRUE(support::same_bits(saturated.state.rolling, dry.state.rolling)) << tick;
            ASSERT_TRUE(support::same_bits(saturated.state.depth, dry.state.depth)) << tick;
            ASSERT_TRUE(support::same_bits(saturated.state.velocity_y, dry.state.velocity_y)) << tick;
        }
        EXPECT_FALSE(support::same_bits(other.state.rolling, dry.state.rolling));
    }
}

TEST(Water, brakes_less_by_what_it_carries) {
    Ground ground = soil(20, 5, 0, 1);
    ground.set(ground.rolling, [](double, double) { return 1.0; });
    sim::Params params;
    params.model = Model::kVoellmy;
    params.friction = 0.3f, params.drag = 1e6f;
    for (const auto& [m, share] : {std::pair{0.f, 1.0}, {0.4f, 0.8}, {1.f, 0.5}}) {
        Play play(ground, params);
        saturate(play.state, m);
        for (int y = 0; y < 21; ++y)
            std::fill(play.state.velocity_x.row(y), play.state.velocity_x.row(y) + 21, 10.f);
        play.ticks(60);
        EXPECT_NEAR(static_cast<double>(play.state.velocity_x(10, 10)), 10 - 0.3 * 9.81 * share, 0.01) << m;
    }
}

// An infinite slope: tan ψ = f times the slope at which dry ground starts.
TEST(Slope, lets_go_at_the_share_of_water_that_the_formula_gives) {
    for (const double tangent : {0.45, 0.55, 0.65})
        for (const double density : {1500.0, 1800.0, 2200.0})
            for (const double anchor_step : {0.0, 1.0}) {
                sim::Params params = support::lively(Model::kBcreInertial);
                params.start_slope = 0.75f;
                params.anchor_step = static_cast<float>(anchor_step);
                Ground ground = soil(20, 5, tangent, 0.5);
                ground.density = static_cast<float>(density);
                Play play(ground, params);
                const double anchored = 1.02 * tangent + 0.02 + anchor_step / 10;
                const double m = (1 - tangent / std::max(anchored, 0.75)) * density / 1000;
                ASSERT_LT(m, 1);
                const Command shower = wet(50, 50, 30, 0.1, 100);
                play.ticks(1, {&shower, 1});
                while (play.state.rolling(10, 10) == 0 && play.state.tick < 300) play.ticks(1);
                const auto in_a_tick = 0.1 / 60 / (0.4 * 0.5);
                EXPECT_GE(static_cast<double>(m_at(play, 10, 10)), m - 1e-5) << tangent << ", " << density;
                EXPECT_LE(static_cast<double>(m_at(play, 10, 10)), m + in_a_tick + 1e-5)
                    << tangent << ", " << density;
            }
}

TEST(Slope, that_is_dry_or_forested_holds_where_a_wet_one_lets_go) {
    // Saturated, it would start at .52 bare, at .87 if its roots were as weak as wet soil, and at 1.73 with them.
    Ground ground = soil(40, 5, 0.9, 1);
    ground.forest.resize(ground.grid.size());
    for (int y = 0; y < ground.grid.ny; ++y)
        for (int x = 20; x < 41; ++x) ground.forest[ground.at(x, y)] = {400, 0, 30, 22};
    sim::Params params = support::lively(Model::kBcreInertial);
    Play play(ground, params);
    const Command shower = wet(100, 100, 40, 0.1, 10);
    play.ticks(400, {&shower, 1});
    EXPECT_LT(play.state.depth(16, 20), 1) << "wet and bare";
    EXPECT_EQ(play.state.depth(26, 20), 1) << "wet under a forest";
    EXPECT_EQ(m_at(play, 26, 20), 1);
    EXPECT_EQ(play.state.depth(10, 4), 1) << "dry and bare";
    EXPECT_EQ(play.state.ledger.mass_error(), 0);
}

std::vector<Command> showers(int tick) {
    if (tick == 5) return {wet(60, 60, 30, 0.1, 1), wet(150, 120, 60, 0.08, 2)};
    if (tick == 40) return {drain(150, 120, 20, 0.1, 1), wet(200, 200, 0, 0.1, 1)};
    return {};
}

TEST(Water, acts_alike_in_plain_step_and_sweep_on_any_threads_and_lanes) {
    for (const Model model : {Model::kBcreInertial, Model::kVoellmy}) {
        Ground ground = soil(60, 5, 0.5, 1);
        ground.set(ground.rolling,
                   [](double x, double y) { return std::hypot(x - 150, y - 60) < 30 ? 2.0 : 0.0; });
        for (int x = 20; x < 25; ++x) ground.has_data[ground.at(x, x)] = 0;
        const sim::Params params = support::lively(model);
        Play plain(ground, params, {.plain = true});
        std::vector<std::unique_ptr<Play>> swept;
        const auto add = [&](const sim::StepOptions& options) {
            swept.push_back(std::make_unique<Play>(ground, params, options));
        };
        for (const sim::InstructionSet set : sim::kInstructionSets)
            for (const int threads : {1, 3})
                if (sim::has(set))
                    add({.threads = threads, .instruction_set = set, .tile_width = 32, .tile_height = 16});
        add({.tile_width = 32, .tile_height = 8, .tiles_may_sleep = false});
        for (int tick = 0; tick < 160; ++tick) {
            plain.ticks(1, showers(tick));
            for (const auto& each : swept) {
                Play& play = *each;
                play.ticks(1, showers(tick));
                ASSERT_EQ(sim::state_hash(play.state), sim::state_hash(plain.state)) << tick;
                ASSERT_EQ(sim::update_state_hash(play.state, play.engine.workers),
                          sim::state_hash(play.state));
            }
        }
        EXPECT_EQ(plain.state.ledger.mass_error(), 0);
        EXPECT_FALSE(plain.state.things->dry());
    }
}

TEST(Water, wakes_what_may_start) {
    Play sleeping(soil(150, 5, 0.65, 1), support::lively(Model::kBcreInertial),
                  {.tile_width = 32, .tile_height = 16});
    sleeping.ticks(2);
    const auto& awake = sleeping.state.tiles.awake;
    ASSERT_EQ(std::count(awake.begin(), awake.end(), 1), 0);
    const Command shower = wet(400, 400, 30, 0.1, 5);
    sleeping.ticks(300, {&shower, 1});
    EXPECT_GT(sleeping.state.ledger.rolling + sleeping.state.ledger.out, 0);
}

TEST(Water, is_in_the_hash_and_named_and_leaves_no_trace_once_drained) {
    Play touched(soil(20, 5, 0, 1), support::lively(Model::kBcreInertial)),
        never(soil(20, 5, 0, 1), support::lively(Model::kBcreInertial));
    const Command shower = wet(50, 50, 20, 0.05, 0), pump = drain(50, 50, 20, 0.05, 0);
    touched.ticks(1, {&shower, 1}), never.ticks(1);
    EXPECT_NE(sim::state_hash(touched.state), sim::state_hash(never.state));
    EXPECT_EQ(sim::update_state_hash(touched.state, touched.engine.workers), sim::state_hash(touched.state));
    const auto named = sim::fields_of(touched.state);
    EXPECT_EQ(named.back().name, "water");
    EXPECT_EQ(named.back().values, &touched.state.things->water);
    touched.ticks(1, {&pump, 1}), never.ticks(1);
    EXPECT_EQ(sim::state_hash(touched.state), sim::state_hash(never.state));
    EXPECT_TRUE(touched.state.things->empty());

    // Beside something else, dry soil has the hash that it had before there was water.
    Ground forested = soil(20, 5, 0, 1);
    forested.forest.assign(forested.grid.size(), {400, 0, 30, 22});
    Play forest(forested, support::lively(Model::kBcreInertial));
    const std::uint64_t dry = sim::state_hash(forest.state);
    saturate(forest.state, 0x1p-24f);
    EXPECT_NE(sim::state_hash(forest.state), dry);
    saturate(forest.state, 0);
    EXPECT_EQ(sim::state_hash(forest.state), dry);
}

TEST(Water, comes_and_goes_with_snapshots_and_has_the_same_future) {
    for (const bool begins_wet : {false, true}) {
        Play play(soil(40, 5, 0.6, 1), support::lively(Model::kBcreInertial));
        const Command first = wet(60, 60, 30, 0.1, 3), later = wet(120, 120, 40, 0.1, 2);
        play.ticks(30, {&first, begins_wet ? 1u : 0u});
        const sim::Snapshot before = sim::take_snapshot(play.state);
        std::vector<std::uint64_t> hashes;
        for (const bool again : {false, true}) {
            if (again) sim::restore(before, play.state);
            for (std::size_t i = 0; i < 120; ++i) {
                play.ticks(1, {&later, i == 10 ? 1u : 0u});
                const std::uint64_t hash = sim::update_state_hash(play.state, play.engine.workers);
                ASSERT_EQ(sim::state_hash(play.state), hash);
                if (again)
                    ASSERT_EQ(hash, hashes.at(i)) << i;
                else
                    hashes.push_back(hash);
            }
        }
        EXPECT_GT(play.state.ledger.rolling + play.state.ledger.out, 0);
    }
}

TEST(Water, is_refused_where_it_has_no_rule) {
    const Command commands[] = {wet(50, 50, 10, 0.1, 1), drain(50, 50, 10, 0.1, 1)};
    const auto fault_in = [&](Model model, float density, const Command& command) {
        Ground ground = soil(20, 5, 0, 1);
        ground.density = density;
        const Play play(ground, support::lively(model));
        const auto now = sim::fault_of_things(play.state, {&command, 1});
        const std::string ahead = sim::fault_of_place(play.state, command).value_or("");
        EXPECT_EQ(now ? now->fact : "", ahead);
        return ahead;
    };
    for (const Command& command : commands)
        for (const Model model : {Model::kBcreInertial, Model::kVoellmy}) {
            EXPECT_EQ(fault_in(model, 1800, command), "");
            EXPECT_NE(fault_in(model, 0, command).find("has none"), std::string::npos);
            EXPECT_NE(fault_in(model, 1000, command).find("has 1000 kg/m3"), std::string::npos);
        }
    EXPECT_NE(fault_in(Model::kBcre, 1800, commands[0]).find("this world has bcre"), std::string::npos);

    Ground two = soil(20, 5, 0, 1);
    two.lower = support::lively(Model::kBcreInertial);
    two.lower_density = 300;
    const Play play(two, *two.lower);
    EXPECT_TRUE(sim::fault_of_things(play.state, commands));
}

// By the density of what the bed is made of, which the mixture gives.
TEST(Water, acts_by_the_density_of_the_material_under_it) {
    for (const auto& [lower_density, lets_go] : {std::pair{1500.f, true}, {2500.f, false}}) {
        sim::Params params = support::lively(Model::kBcreInertial);
        params.anchor_step = 0;
        Ground ground = soil(20, 5, 0.35, 1);
        ground.density = 3000;
        ground.lower = params;
        ground.lower_density = lower_density;
        ground.lower_depth = ground.depth;
        Play play(ground, params);
        const Command shower = wet(50, 50, 30, 0.1, 20);
        play.ticks(400, {&shower, 1});
        EXPECT_EQ(play.state.ledger.rolling + play.state.ledger.out > 0, lets_go) << lower_density;
        EXPECT_EQ(play.state.ledger.mass_error(), 0);
    }
}

}  // namespace
