#include "sim/powder/cloud.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "sim/initial_state.h"

namespace {

using sim::powder::Cloud;
using sim::powder::Puff;

constexpr float kTick = 1 / 60.f;

// A slope that falls to the east. A patch of it flows east.
class Powder : public testing::Test {
  protected:
    static sim::State make() {
        const sim::Grid grid{65, 33, 10};
        std::vector<float> bedrock, none(grid.size());
        const std::vector<std::uint8_t> has_data(grid.size(), 1);
        for (int y = 0; y < grid.ny; ++y)
            for (int x = 0; x < grid.nx; ++x) bedrock.push_back(-0.6f * static_cast<float>(x) * grid.dx);
        return sim::make_state(
            {.grid = grid, .bedrock = bedrock, .depth = none, .rolling = none, .has_data = has_data}, {});
    }
    void flow(float speed, float depth = 1) {
        for (int y = 10; y < 22; ++y)
            for (int x = 10; x < 30; ++x) {
                state.rolling(x, y) = depth;
                state.velocity_x(x, y) = speed;
            }
    }
    void stop() {
        state.rolling.fill(0);
        state.velocity_x.fill(0);
    }
    void run(Cloud& cloud, int ticks) {
        for (int i = 0; i < ticks; ++i) {
            ++state.tick;
            cloud.advance(sim::view(state), kTick);
        }
    }

    sim::State state = make();
};

TEST_F(Powder, rises_over_a_fast_flow_only) {
    Cloud cloud({.strength = 1, .speed = 7});
    flow(6.9f);
    run(cloud, 60);
    EXPECT_TRUE(cloud.puffs().empty());
    flow(25, 0.01f);
    run(cloud, 60);
    EXPECT_TRUE(cloud.puffs().empty()) << "a film";
    flow(25);
    run(cloud, 60);
    EXPECT_GT(cloud.puffs().size(), 50u);
}

TEST_F(Powder, is_born_in_tiles_that_are_awake_only) {
    Cloud all({.strength = 1, .speed = 7}), some = all, none = all;
    flow(25);
    run(all, 60);
    state.tick = 0;
    state.tiles = sim::Tiles(state.grid, 32, 11);
    for (int column = 1; column < state.tiles.columns; ++column)
        for (int row = 0; row < state.tiles.rows; ++row)
            state.tiles.awake[state.tiles.number(column, row)] = 0;
    run(some, 60);
    EXPECT_GT(some.puffs().size(), 50u);
    EXPECT_TRUE(std::equal(all.puffs().begin(), all.puffs().end(), some.puffs().begin(), some.puffs().end()));
    std::fill(state.tiles.awake.begin(), state.tiles.awake.end(), std::uint8_t{0});
    run(none, 60);
    EXPECT_TRUE(none.puffs().empty());
}

TEST_F(Powder, of_a_material_without_any_is_none) {
    Cloud cloud({.strength = 0, .speed = 7});
    flow(40);
    run(cloud, 60);
    EXPECT_TRUE(cloud.puffs().empty());
}

TEST_F(Powder, is_thickest_at_the_front) {
    Cloud cloud({.strength = 1, .speed = 7});
    flow(25);
    run(cloud, 1);
    double front = 0, back = 0;
    for (int i = 0; i < 400; ++i) {
        cloud.restore({});
        run(cloud, 1);
        for (const Puff& puff : cloud.puffs()) front += puff.at.x > 255, back += puff.at.x < 195;
    }
    EXPECT_GT(front / 4, 2 * back / 10) << "per column of vertices";
}

TEST_F(Powder, has_fine_dust_at_the_sides_of_its_front) {
    Cloud cloud({.strength = 1, .speed = 7});
    flow(25);
    int aside = 0, high = 0, all = 0;
    for (int i = 0; i < 100; ++i) {
        cloud.restore({});
        run(cloud, 1);
        for (const Puff& puff : cloud.puffs()) {
            aside += std::abs(puff.velocity.y) > 4;
            high += puff.velocity.z + 0.6f * puff.velocity.x > 15;
            ++all;
        }
    }
    EXPECT_GT(aside, all / 20);
    EXPECT_GT(high, all / 50) << "ragged top";
    EXPECT_LT(high, all / 3);
}

TEST_F(Powder, travels_down_with_the_flow_and_stays_above_the_ground) {
    Cloud cloud({.strength = 1, .speed = 7});
    flow(25);
    run(cloud, 1);
    while (cloud.puffs().empty()) run(cloud, 1);
    const Puff born = cloud.puffs().front();
    run(cloud, 60);
    const Puff later = cloud.puffs().front();
    EXPECT_GT(later.at.x, born.at.x + 8);
    EXPECT_LT(later.at.x, born.at.x + 32);
    for (const Puff& puff : cloud.puffs()) EXPECT_GT(puff.at.z, -0.6f * puff.at.x - 0.1f);
}

TEST_F(Powder, fades_in_and_out_without_a_jump) {
    Cloud cloud({.strength = 1, .speed = 7});
    flow(25);
    run(cloud, 1);
    while (cloud.puffs().empty()) run(cloud, 1);
    stop();
    float before = 0, most = 0;
    while (!cloud.puffs().empty()) {
        const float now = opacity(cloud.puffs().front());
        EXPECT_LT(std::abs(now - before), 0.09f);
        most = std::max(most, before = now);
        cloud.restore(cloud.puffs().first(1));
        run(cloud, 1);
    }
    EXPECT_LT(before, 0.01f);
    EXPECT_GT(most, 0.3f);
}

TEST_F(Powder, has_settled_twelve_seconds_after_the_flow_stops) {
    Cloud cloud({.strength = 1, .speed = 7});
    flow(25);
    run(cloud, 120);
    stop();
    run(cloud, 300);
    EXPECT_FALSE(cloud.puffs().empty()) << "it lingers";
    run(cloud, 420);
    EXPECT_TRUE(cloud.puffs().empty());
}

TEST_F(Powder, never_has_more_puffs_than_its_limit) {
    Cloud cloud({.strength = 1, .speed = 0.1f});
    for (int y = 0; y < state.grid.ny; ++y)
        for (int x = 0; x < state.grid.nx; ++x) {
            state.rolling(x, y) = 5;
            state.velocity_x(x, y) = x % 2 == 0 ? 2.f : 140.f;
        }
    for (int i = 0; i < 200; ++i) {
        run(cloud, 1);
        ASSERT_LE(cloud.puffs().size(), Cloud::kMost);
        for (const Puff& puff : cloud.puffs())
            ASSERT_TRUE(std::isfinite(puff.at.x + puff.at.y + puff.at.z + radius(puff)));
    }
    EXPECT_GT(cloud.puffs().size(), Cloud::kMost / 2);
    for (int i = 0; i < 100; ++i) cloud.blast(sim::view(state), {300, 160}, 20);
    EXPECT_LE(cloud.puffs().size(), Cloud::kMost);
}

TEST_F(Powder, depends_on_its_puffs_and_the_world_alone) {
    Cloud one({.strength = 1, .speed = 7}), two({.strength = 1, .speed = 7});
    flow(25);
    run(one, 100);
    two.restore(one.puffs());
    for (int i = 0; i < 60; ++i) {
        ++state.tick;
        one.advance(sim::view(state), kTick);
        two.advance(sim::view(state), kTick);
    }
    EXPECT_TRUE(std::equal(one.puffs().begin(), one.puffs().end(), two.puffs().begin(), two.puffs().end()));
}

// FNV-1a over the bits of all puffs.
std::uint64_t hash_of(std::span<const Puff> puffs) {
    static_assert(sizeof(Puff) == 48, "without padding");
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const std::byte each : std::as_bytes(puffs))
        hash = (hash ^ static_cast<std::uint64_t>(each)) * 0x100000001b3;
    return hash;
}

TEST_F(Powder, has_the_same_bits_with_every_compiler) {
    Cloud cloud({.strength = 1, .speed = 7});
    state.depth.fill(1);
    flow(25);
    run(cloud, 100);
    cloud.blast(sim::view(state), {200, 160}, 15);
    run(cloud, 60);
    EXPECT_EQ(hash_of(cloud.puffs()), 14996469959615299974u);
}

TEST_F(Powder, drifts_with_the_wind_and_faster_where_it_is_high_and_old) {
    Cloud calm({.strength = 1, .speed = 7}), windy({.strength = 1, .speed = 7}, {}, {0, 10});
    flow(25);
    run(calm, 1);
    while (calm.puffs().empty()) run(calm, 1);
    windy.restore(calm.puffs());
    const auto drift = [&](int ticks) {  // of the first puff to the north, m
        for (int i = 0; i < ticks; ++i) {
            ++state.tick;
            calm.advance(sim::view(state), kTick);
            windy.advance(sim::view(state), kTick);
        }
        EXPECT_EQ(calm.puffs().front().at.x, windy.puffs().front().at.x) << "across the wind";
        return windy.puffs().front().at.y - calm.puffs().front().at.y;
    };
    stop();
    const float soon = drift(60), later = drift(60) - soon;
    EXPECT_GT(soon, 0.05f);
    EXPECT_LT(soon, 5) << "slower than the wind";
    EXPECT_GT(later, 1.5f * soon);
    EXPECT_LT(later, 10) << "no faster than the wind";
}

TEST_F(Powder, has_the_same_bits_in_wind_with_every_compiler) {
    Cloud cloud({.strength = 1, .speed = 7}, {}, {-3.1f, 7.7f});
    state.depth.fill(1);
    flow(25);
    run(cloud, 160);
    EXPECT_EQ(hash_of(cloud.puffs()), 14155533246192833565u);
}

TEST_F(Powder, is_thrown_by_a_blast_where_something_lies) {
    Cloud cloud({.strength = 1, .speed = 7});
    cloud.blast(sim::view(state), {200, 160}, 15);
    EXPECT_TRUE(cloud.puffs().empty()) << "bare ground";
    state.depth.fill(1);
    cloud.blast(sim::view(state), {1e6f, 160}, 15);
    EXPECT_TRUE(cloud.puffs().empty()) << "outside";
    cloud.blast(sim::view(state), {200, 160}, 15);
    EXPECT_GT(cloud.puffs().size(), 20u);
    run(cloud, 400);
    EXPECT_TRUE(cloud.puffs().empty());
}

}  // namespace
