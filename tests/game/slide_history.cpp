#include "game/analysis/slide_history.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/world/things.h"
#include "tests/support/worlds.h"

namespace game::test {
namespace {

constexpr double kTickS = 1.0 / 60, kHistoryCell = 10;  // s, m
constexpr double kDownhill = 0.75;                      // tangent; 1.25 along the slope for 1 in plan

// A plane that falls to the north, on which a patch of flow is put where it is wanted.
class HistoryOfASlide : public testing::Test {
  protected:
    HistoryOfASlide() {
        const support::Ground ground = support::plane(60, kHistoryCell, kDownhill, 1);
        world_ = sim::make_state(ground.world(), support::lively(sim::Model::kBcre));
        peaks_.depth.assign(world_.grid.size(), 0);
    }
    // 2 m of flow at one vertex, at this speed in plan; nothing else flows.
    void flow_at(int y, float speed) {
        for (int j = 0; j < world_.grid.ny; ++j)
            for (int i = 0; i < world_.grid.nx; ++i) world_.rolling(i, j) = world_.velocity_y(i, j) = 0;
        world_.rolling(30, y) = 2, world_.velocity_y(30, y) = speed;
    }
    void see(std::int64_t tick) {
        world_.tick = tick;
        known_ = std::max(known_, tick);
        history_.see(sim::view(world_), peaks_, Densities{300, 300}, kTickS, known_);
    }
    const SlideHistory::Sample& last() const { return history_.samples().back(); }

    sim::State world_;
    Peaks peaks_;
    std::int64_t known_ = 0;
    SlideHistory history_;
};

TEST_F(HistoryOfASlide, has_run_out_volume_and_speed_of_what_moves) {
    see(0);
    EXPECT_EQ(last().volume, 0);
    EXPECT_EQ(last().run_out, 0);
    flow_at(10, 20);
    see(6);
    EXPECT_DOUBLE_EQ(last().volume, 2 * kHistoryCell * kHistoryCell);
    EXPECT_NEAR(last().speed, 1.25 * 20, 1e-3);
    EXPECT_EQ(last().run_out, 0);
    EXPECT_EQ(last().top, glm::dvec2(300, 100));
    flow_at(25, 30);
    see(12);
    EXPECT_DOUBLE_EQ(last().run_out, 150);
    flow_at(40, 0.1f);  // has come to rest as good as
    see(18);
    EXPECT_DOUBLE_EQ(last().run_out, 150);
    EXPECT_EQ(last().volume, 0);
    EXPECT_EQ(last().speed, 0);
}

TEST_F(HistoryOfASlide, begins_the_run_out_anew_with_another_slide) {
    flow_at(10, 20), see(6);
    flow_at(30, 20), see(12);
    EXPECT_DOUBLE_EQ(last().run_out, 200);
    flow_at(5, 20), see(12 + 6 * 60);
    EXPECT_EQ(last().run_out, 0);
    EXPECT_EQ(last().top, glm::dvec2(300, 50));
}

TEST_F(HistoryOfASlide, takes_the_run_out_of_what_flowed_before_it_began) {
    peaks_.depth[10 * static_cast<std::size_t>(world_.grid.nx) + 30] = 1;
    peaks_.depth[40 * static_cast<std::size_t>(world_.grid.nx) + 30] = 1;
    see(600);
    EXPECT_DOUBLE_EQ(last().run_out, 300);
    EXPECT_EQ(history_.since(), 600);
}

TEST_F(HistoryOfASlide, drops_every_second_sample_when_it_is_full) {
    const auto most = static_cast<std::int64_t>(SlideHistory::kMostSamples);
    for (std::int64_t tick = 0; tick < SlideHistory::kStep * most; ++tick) see(tick);
    EXPECT_EQ(history_.samples().size(), SlideHistory::kMostSamples);
    EXPECT_EQ(history_.step(), SlideHistory::kStep);
    see(SlideHistory::kStep * most);
    EXPECT_EQ(history_.step(), 2 * SlideHistory::kStep);
    EXPECT_EQ(history_.samples().size(), SlideHistory::kMostSamples / 2 + 1);
    for (const SlideHistory::Sample& sample : history_.samples())
        EXPECT_EQ(sample.tick % (2 * SlideHistory::kStep), 0);
}

TEST_F(HistoryOfASlide, keeps_what_is_known_while_time_is_watched_and_forgets_it_if_time_is_another) {
    for (std::int64_t tick = 0; tick <= 60; tick += 6)
        flow_at(10 + static_cast<int>(tick) / 6, 20), see(tick);
    EXPECT_EQ(history_.samples().size(), 11u);
    flow_at(50, 1), see(30);  // watched again: the same is known
    EXPECT_EQ(history_.samples().size(), 11u);
    EXPECT_GT(history_.samples()[5].speed, 10);
    known_ = 30;  // undone until there
    see(30);
    EXPECT_EQ(history_.samples().size(), 6u);
    EXPECT_LT(last().speed, 10);
    see(36);
    EXPECT_EQ(history_.samples().size(), 7u);
}

TEST_F(HistoryOfASlide, fills_gaps_that_were_passed_over) {
    see(0), see(60);
    known_ = 60;
    see(30);
    ASSERT_EQ(history_.samples().size(), 3u);
    EXPECT_EQ(history_.samples()[1].tick, 30);
}

TEST_F(HistoryOfASlide, has_the_pressure_at_each_house_as_long_as_it_stands) {
    sim::Command house{.kind = sim::CommandKind::kHouse, .x = 300, .y = 300};
    house.length = 12, house.width = 10, house.height = 8, house.strength = 30;
    world_.things.emplace(world_.grid);
    world_.things->natural = world_.bedrock;
    sim::build(world_, house);
    sim::rebuild_objects(world_);
    flow_at(30, 20);
    see(0);
    ASSERT_EQ(history_.houses().size(), 1u);
    EXPECT_EQ(history_.houses()[0].at, glm::dvec2(300, 300));
    const double speed = 1.25 * 20;
    EXPECT_NEAR(last().pressure[0], 300 * speed * speed / 1000, 0.1);
    world_.things->list.clear();
    see(6);
    EXPECT_FALSE(history_.houses()[0].thing);
    EXPECT_EQ(last().pressure[0], 0);
}

}  // namespace
}  // namespace game::test
