#include "sim/engine.h"

#include <random>

#include <gtest/gtest.h>

#include "sim/world/state_hash.h"
#include "tests/support/worlds.h"

// The sweep is bit-identical to the plain step, with every instruction set of this machine, any number of
// threads, any tile size, and with or without sleeping tiles.

namespace {

using sim::Law;
using sim::StepOptions;
using support::kPhysics;
using support::Physics;
using support::Play;

// All step options that apply on this machine.
std::vector<StepOptions> ways() {
    std::vector<StepOptions> all;
    for (const auto set : sim::kInstructionSets)
        if (sim::has(set))
            for (const int threads : {1, 3}) all.push_back({.threads = threads, .instruction_set = set});
    all.push_back({.threads = 8, .tile_width = 32, .tile_height = 1});
    all.push_back({.tile_width = 32, .tile_height = 2});
    all.push_back({.threads = 5, .tile_width = 32, .tile_height = 9});
    // Jobs that end or begin so near a border that it is the last row they read.
    all.push_back({.threads = 3, .tile_width = 32, .tile_height = 20});
    all.push_back({.threads = 10, .tile_width = 32, .tile_height = 5});
    all.push_back({.tile_width = 128, .tile_height = 200});
    all.push_back({.threads = 2, .tiles_may_sleep = false});
    return all;
}

std::string name_of(const StepOptions& options) {
    return std::string(sim::to_string(options.instruction_set)) + ", threads " +
           std::to_string(options.threads) + ", tiles " + std::to_string(options.tile_width) + " by " +
           std::to_string(options.tile_height);
}

// Steps worlds with all options next to a plain one and compares them at each tick.
void expect_same(const support::Ground& ground, const sim::Params& params, int ticks,
                 const std::function<std::vector<sim::Command>(int tick)>& commands,
                 const std::string& what) {
    Play plain(ground, params, {.plain = true});
    std::vector<std::unique_ptr<Play>> others;
    for (const StepOptions& options : ways())
        others.push_back(std::make_unique<Play>(ground, params, options));
    for (int tick = 0; tick < ticks; ++tick) {
        const auto given = commands(tick);
        plain.ticks(1, given);
        ASSERT_EQ(plain.state.ledger.mass_error(), 0) << what << ", tick " << tick;
        for (const auto& other : others) {
            other->ticks(1, given);
            ASSERT_EQ(sim::state_hash(other->state), sim::state_hash(plain.state))
                << what << ", " << name_of(other->engine.options) << ", tick " << tick;
            ASSERT_EQ(other->state.ledger, plain.state.ledger) << what << ", tick " << tick;
        }
    }
}

std::vector<sim::Command> nothing(int) {
    return {};
}

TEST(Sweep, is_the_plain_step_to_the_bit_by_every_law_and_border) {
    for (const Physics& physics : kPhysics)
        for (const Law law : {Law::kConstant, Law::kSlope, Law::kShear})
            for (const auto border : {sim::Border::kWall, sim::Border::kOpen, sim::Border::kSink}) {
                sim::Params params = support::lively(physics.model, physics.scheme);
                params.law = law;
                params.speed_per_slope = 7;
                params.max_speed = 8;
                params.borders = {border, sim::Border::kOpen, border, sim::Border::kWall};
                support::Ground ground = support::rough(44, 2, 5);
                for (int x = 20; x < 25; ++x) ground.has_data[ground.at(x, x)] = 0;
                expect_same(ground, params, 40, nothing,
                            physics.name() + ", " + std::string(sim::to_string(law)));
            }
}

TEST(Sweep, is_the_plain_step_to_the_bit_where_the_exchange_is_strong_and_the_flow_thick) {
    for (const Physics& physics : kPhysics)
        for (const float depth : {0.2f, 128.f})
            for (const float rate : {0.f, 20.f, 100.f}) {
                sim::Params params = support::lively(physics.model, physics.scheme);
                params.exchange_rate = rate;
                params.exchange_depth = depth;
                support::Ground ground = support::rough(40, 1, 8);
                ground.set(ground.bedrock, [&](double x, double y) {  // cliffs
                    return -0.6 * y + 30 * std::floor(x / 13);
                });
                expect_same(ground, params, 40, nothing, physics.name());
            }
}

TEST(Sweep, is_the_plain_step_to_the_bit_with_every_friction) {
    const struct {
        int eighths;
        float fluidization, cohesion_depth, greatest_speed, levelling;
    } trials[] = {{3, 0.222f, 0.04f, 150, 1}, {4, 0, 0.04f, 10, 0.5f}, {8, 0.222f, 0, 150, 0}};
    for (const sim::Model model : {sim::Model::kBcreInertial, sim::Model::kVoellmy})
        for (const auto& trial : trials) {
            sim::Params params = support::lively(model);
            params.drag_exponent = static_cast<float>(trial.eighths) / 8;
            params.fluidization = trial.fluidization;
            params.cohesion_depth = trial.cohesion_depth;
            params.greatest_speed = trial.greatest_speed;
            params.levelling = trial.levelling;
            expect_same(support::rough(40, 2, 5), params, 30, nothing,
                        std::string(sim::to_string(model)) + ", eighths " + std::to_string(trial.eighths));
        }
}

TEST(Sweep, is_the_plain_step_to_the_bit_under_any_hand_while_most_of_the_world_sleeps) {
    for (const Physics& physics : kPhysics) {
        support::Ground ground = support::plane(150, 2, 0.62, 2);  // between stop and start
        std::mt19937 random(4);
        const auto hand = [&](int tick) -> std::vector<sim::Command> {
            if (tick % 25) return {};
            const double x = static_cast<double>(random() % 300), y = static_cast<double>(random() % 300);
            sim::Command command = support::pour_at(x, y, 6, 20, 0.2);
            if (tick % 50 == 0) {
                command.kind = sim::CommandKind::kBlast;
                command.depth = 1;
            }
            return {support::of_its_kind(command)};
        };
        expect_same(ground, support::lively(physics.model, physics.scheme), 200, hand, physics.name());
    }
}

TEST(Sweep, lets_tiles_at_rest_sleep) {
    Play play(support::plane(150, 2, 0.62, 2), support::lively(sim::Model::kBcre));
    const auto awake = [&] {
        return std::count(play.state.tiles.awake.begin(), play.state.tiles.awake.end(), 1);
    };
    EXPECT_EQ(awake(), static_cast<std::ptrdiff_t>(play.state.tiles.awake.size()));
    play.ticks(1);
    EXPECT_EQ(awake(), 0);
    const sim::Command pour = support::pour_at(20, 20, 4, 40, 0.1);
    play.ticks(1, {&pour, 1});
    EXPECT_EQ(awake(), 1);
}

TEST(Sweep, opens_all_tiles_in_each_tick_if_tiles_may_not_sleep) {
    Play play(support::plane(150, 2, 0.62, 2), support::lively(sim::Model::kBcre),
              {.tiles_may_sleep = false});
    for (int tick = 0; tick < 3; ++tick) {
        sim::update_state_hash(play.state, play.engine.workers);
        play.ticks(1);
        const sim::Tiles& tiles = play.state.tiles;
        EXPECT_EQ(std::count(tiles.awake.begin(), tiles.awake.end(), 0), 0);
        EXPECT_EQ(std::count(tiles.unhashed.begin(), tiles.unhashed.end(), 0), 0);
    }
}

// Tiles are 64 by 32 vertices, 2 m apart.
TEST(Sweep, wakes_only_tiles_near_the_rolling_layer) {
    const auto awake_after_pouring_at = [](double x, double y) {
        Play play(support::plane(150, 2, 0.62, 2), support::lively(sim::Model::kBcre));
        play.ticks(1);
        const sim::Command pour = support::pour_at(x, y, 2, 40, 0.1);
        play.ticks(1, {&pour, 1});
        return std::count(play.state.tiles.awake.begin(), play.state.tiles.awake.end(), 1);
    };
    EXPECT_EQ(awake_after_pouring_at(64, 32), 1);
    EXPECT_EQ(awake_after_pouring_at(127, 32), 2);
    EXPECT_EQ(awake_after_pouring_at(64, 63), 2);
    EXPECT_EQ(awake_after_pouring_at(127, 63), 4);
}

}  // namespace
