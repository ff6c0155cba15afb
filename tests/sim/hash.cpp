#include "sim/state_hash.h"

#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/worlds.h"

namespace {

using support::Play;

// A world in the middle of things.
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
    play.state.velocity_x(5, 4) = -2.5f;  // what a word-wise FNV does not see
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

TEST(StateHash, sees_tick_sources_and_seed_but_not_the_halo) {
    World play;
    const std::uint64_t before = sim::state_hash(play.state);
    ++play.state.tick;
    EXPECT_NE(sim::state_hash(play.state), before);
    --play.state.tick;
    play.state.sources.push_back({support::pour_at(1, 2, 3, 4, 5), 0});
    EXPECT_NE(sim::state_hash(play.state), before);
    play.state.sources.clear();
    ++play.state.seed;
    EXPECT_NE(sim::state_hash(play.state), before);
    --play.state.seed;
    play.state.depth(-1, 3) = 99;
    EXPECT_EQ(sim::state_hash(play.state), before);
}

}  // namespace
