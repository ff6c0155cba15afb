#include "sim/world/state_hash.h"

#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "sim/world/snapshot.h"
#include "tests/support/worlds.h"

namespace {

using support::Play;

// A world in motion.
struct World : Play {
    World() : Play(support::rough(16, 2, 21), support::lively(sim::Model::kBcreInertial)) { ticks(30); }
};

TEST(StateHash, changes_with_a_single_bit_anywhere) {
    World play;
    const std::uint64_t before = sim::state_hash(play.state);
    for (sim::Field<float>* field : {&play.state.bedrock, &play.state.depth, &play.state.rolling,
                                     &play.state.velocity_x, &play.state.velocity_y}) {
        for (const auto& [x, y] : {std::pair(0, 0), std::pair(16, 18), std::pair(7, 9)}) {
            float& value = (*field)(x, y);
            const float kept = value;
            value = std::nextafter(value, std::numeric_limits<float>::max());  // one ULP
            EXPECT_NE(sim::state_hash(play.state), before);
            value = kept;
        }
        EXPECT_EQ(sim::state_hash(play.state), before);
    }
}

TEST(StateHash, sees_the_signs_of_neighbours_and_of_zero) {
    World play;
    play.state.velocity_x(4, 4) = 1.5f;
    play.state.velocity_x(5, 4) = 2.5f;
    play.state.velocity_y(4, 4) = 0.f;
    const std::uint64_t before = sim::state_hash(play.state);
    play.state.velocity_x(4, 4) = -1.5f;
    play.state.velocity_x(5, 4) = -2.5f;  // a word-wise FNV would miss it
    EXPECT_NE(sim::state_hash(play.state), before);
    play.state.velocity_x(4, 4) = 1.5f;
    play.state.velocity_x(5, 4) = 2.5f;
    play.state.velocity_y(4, 4) = -0.f;
    EXPECT_NE(sim::state_hash(play.state), before);
}

TEST(StateHash, sees_swapped_fields_and_rows) {
    World play;
    const std::uint64_t before = sim::state_hash(play.state);
    std::swap(play.state.velocity_x, play.state.velocity_y);
    EXPECT_NE(sim::state_hash(play.state), before);
    std::swap(play.state.velocity_x, play.state.velocity_y);
    for (int x = 0; x < 17; ++x) std::swap(play.state.depth(x, 3), play.state.depth(x, 4));
    EXPECT_NE(sim::state_hash(play.state), before);
}

TEST(StateHash, includes_tick_and_commands_but_not_the_halo) {
    World play;
    const std::uint64_t before = sim::state_hash(play.state);
    ++play.state.tick;
    EXPECT_NE(sim::state_hash(play.state), before);
    --play.state.tick;
    play.state.running_commands.push_back({support::pour_at(1, 2, 3, 4, 5), 0});
    EXPECT_NE(sim::state_hash(play.state), before);
    play.state.running_commands.clear();
    play.state.depth(-1, 3) = 99;
    EXPECT_EQ(sim::state_hash(play.state), before);
}

// Two values that the command may have: its own, and one bit more.
template <class Value>
std::uint64_t hash_with(World& play, sim::Command command, Value sim::Command::*member, Value value) {
    command.*member = value;
    play.state.running_commands = {{command, 0}};
    return sim::state_hash(play.state);
}

// As the manifest says, so that a command with a new member needs no line here.
TEST(StateHash, includes_every_member_that_a_kind_of_command_uses) {
    World play;
    for (const sim::CommandInfo& info : sim::kCommands) {
        const sim::Command command{.kind = info.kind};
        const auto differs = [&](auto sim::Command::*member, auto one, auto other) {
            return hash_with(play, command, member, one) != hash_with(play, command, member, other);
        };
        for (const sim::CommandNumber& number : info.numbers)
            EXPECT_TRUE(differs(number.value, number.most, std::nextafter(number.most, 0.)))
                << info.name << "'s " << number.name;
        if (info.has_layer) {
            EXPECT_TRUE(differs(&sim::Command::layer, sim::Layer::kRolling, sim::Layer::kStanding));
        }
        if (info.has_profile) {
            EXPECT_TRUE(differs(&sim::Command::profile, sim::Profile::kDisc, sim::Profile::kCone));
        }
        if (info.has_part) {
            EXPECT_TRUE(differs(&sim::Command::of, sim::Part::kUpper, sim::Part::kLower));
        }
        if (info.has_param) {
            EXPECT_TRUE(differs(&sim::Command::param, std::size_t{0}, std::size_t{1}));
        }
    }
}

// Recordings compare with it: a new member must not change the hash of a command without it.
TEST(StateHash, of_the_first_kinds_of_command_stays_as_recorded) {
    sim::State state;
    const sim::Command pour = support::pour_at(1, 2, 3, 4, 5);
    sim::Command dig = pour, cone = pour;
    dig.kind = sim::CommandKind::kDig;
    cone.of = sim::Part::kLower, cone.layer = sim::Layer::kStanding, cone.profile = sim::Profile::kCone;
    state.running_commands = {{pour, 6}, {dig, 7}, {cone, 8}};
    EXPECT_EQ(sim::state_hash(state), 0xb523bc271788bdc6);
}

// User input on the way.
std::vector<sim::Command> hand_at(int tick) {
    if (tick == 20) return {support::pour_at(30, 40, 9, 60, 0.5)};
    if (tick != 90) return {};
    sim::Command blast = support::pour_at(150, 150, 20, 0, 0);
    blast.kind = sim::CommandKind::kBlast;
    blast.depth = 1;
    return {blast};
}

std::uint64_t updated_hash(Play& play) {
    return sim::update_state_hash(play.state, play.engine.workers);
}

TEST(UpdatedStateHash, equals_the_full_hash_at_every_tick_with_any_step_options) {
    const support::Ground ground = support::rough(130, 2, 5);
    for (const support::Physics& physics : support::kPhysics)
        for (const sim::StepOptions& options :
             {sim::StepOptions{}, sim::StepOptions{.plain = true},
              sim::StepOptions{.threads = 3, .tile_width = 32, .tile_height = 7},
              sim::StepOptions{.tile_width = 256, .tile_height = 50},
              sim::StepOptions{.tile_width = 32, .tile_height = 1, .tiles_may_sleep = false}}) {
            Play play(ground, support::lively(physics.model, physics.scheme), options);
            for (int tick = 0; tick < 150; ++tick) {
                play.ticks(1, hand_at(tick));
                ASSERT_EQ(updated_hash(play), sim::state_hash(play.state))
                    << physics.name() << ", tiles " << options.tile_width << " by " << options.tile_height
                    << ", tick " << tick;
            }
        }
}

// The last sweep before rest may still change a velocity where no layer changes.
TEST(UpdatedStateHash, equals_the_full_hash_while_a_world_comes_to_rest_and_after) {
    for (const support::Physics& physics : support::kPhysics)
        for (unsigned seed = 1; seed <= 6; ++seed) {
            sim::Params params = support::lively(physics.model, physics.scheme);
            params.borders.fill(sim::Border::kOpen);
            params.friction = 2;  // else films run on, because nothing deposits them
            Play play(support::rough(24, 2, seed), params);
            for (int still = 0, tick = 0; still < 60; ++tick) {
                ASSERT_LT(tick, 6000) << physics.name() << " does not come to rest, seed " << seed;
                play.ticks(1);
                ASSERT_EQ(updated_hash(play), sim::state_hash(play.state))
                    << physics.name() << ", seed " << seed << ", tick " << tick;
                if (sim::at_rest(play.state)) ++still;
            }
        }
}

TEST(UpdatedStateHash, computes_only_blocks_that_were_opened_for_writing) {
    Play play(support::rough(200, 2, 5), support::lively(sim::Model::kBcreInertial));
    const std::uint64_t before = updated_hash(play);
    play.state.tiles.wake(10, 11, 10, 11);
    const std::uint64_t known = play.state.block_hashes.moving.back() +=
        1;  // seen only if it is not recomputed
    EXPECT_NE(updated_hash(play), before);
    EXPECT_EQ(play.state.block_hashes.moving.back(), known);
    play.state.tiles.wake(199, 199, 199, 199);
    EXPECT_EQ(updated_hash(play), before);
}

TEST(UpdatedStateHash, equals_the_earlier_hash_after_a_restore) {
    Play play(support::rough(70, 2, 5), support::lively(sim::Model::kBcreInertial));
    play.ticks(30);
    const std::uint64_t then = updated_hash(play);
    const sim::Snapshot snapshot = sim::take_snapshot(play.state);
    play.ticks(30);
    EXPECT_NE(updated_hash(play), then);
    sim::restore(snapshot, play.state);
    EXPECT_EQ(updated_hash(play), then);
}

TEST(UpdatedStateHash, is_separate_for_each_copy_of_a_state) {
    Play one(support::rough(70, 2, 5), support::lively(sim::Model::kBcreInertial));
    one.ticks(10);
    updated_hash(one);
    sim::State copy = one.state;
    one.ticks(10);
    EXPECT_EQ(sim::update_state_hash(copy, one.engine.workers), sim::state_hash(copy));
    EXPECT_EQ(updated_hash(one), sim::state_hash(one.state));
    std::swap(copy, one.state);
    one.ticks(10);
    EXPECT_EQ(updated_hash(one), sim::state_hash(one.state));
}

}  // namespace
