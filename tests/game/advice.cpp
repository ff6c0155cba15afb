#include "game/analysis/advice.h"

#include <gtest/gtest.h>

#include "sim/world/things.h"
#include "tests/support/worlds.h"

namespace game::test {
namespace {

constexpr float kHouseCell = 10;  // m
constexpr int kHouseVertices = 41;

// A house in the middle of level ground that a flow has pressed.
class Advice : public testing::Test {
  protected:
    Advice() {
        const auto size = static_cast<std::size_t>(kHouseVertices * kHouseVertices);
        peaks_.depth.resize(size);
        peaks_.pressure.resize(size);
        play_.state.things.emplace(play_.state.grid);
        sim::Thing house;
        house.x = house.y = 200, house.strength = 5, house.load = 4000;
        play_.state.things->list.push_back(house);
        house.x = 100, house.load = 9000;
        play_.state.things->list.push_back(house);
        Goal::Need need;
        need.quantity.measure = Measure::kLoad;
        need.most = 4.9;
        goal_.needs.push_back(need);
        score_.needs.push_back({9000, false});
    }
    void flow_at(int x, int y, float depth, float pressure) {
        const auto i = static_cast<std::size_t>(y * kHouseVertices + x);
        peaks_.depth[i] = depth, peaks_.pressure[i] = pressure;
    }
    void heap_up(int x, int y) { play_.state.things->earth(x, y) = 2; }
    std::string text() const { return advice_after(goal_, score_, sim::view(play_.state), peaks_, slab_); }

    Goal goal_;
    Score score_;
    support::Play play_{support::Ground({kHouseVertices, kHouseVertices, kHouseCell}),
                        support::loose_dry_snow()};
    Peaks peaks_;
    std::optional<AttemptWatch::Slab> slab_;
};

TEST_F(Advice, tells_from_where_the_house_with_the_greatest_load_was_hit) {
    EXPECT_EQ(text(), "") << "nothing reached it";
    flow_at(9, 21, 2.125f, 8), flow_at(12, 20, 4, 1);
    flow_at(20, 23, 9, 30);  // at the other house
    EXPECT_EQ(text(),
              "The house with the greatest load was hit from the north-west, by a flow up to 2.1 m deep.");
}

TEST_F(Advice, tells_where_the_flow_came_over_the_earth_or_that_it_went_past) {
    flow_at(10, 22, 2, 8);
    for (int x = 6; x <= 15; ++x) heap_up(x, 25);
    const std::string hit =
        "The house with the greatest load was hit from the north, by a flow up to 2.0 m deep.";
    EXPECT_EQ(text(), hit + " The flow went past your earth.");
    flow_at(6, 25, 0.5f, 1), flow_at(7, 25, 0.5f, 1);
    EXPECT_EQ(text(), hit + " The flow ran over 20 % of your earth, most in the west of it.");
    for (int x = 6; x <= 15; ++x) flow_at(x, 25, 0.5f, 1);
    EXPECT_EQ(text(), hit + " The flow ran over 100 % of your earth.");
}

TEST_F(Advice, tells_how_much_of_the_slab_was_left_if_a_tool_takes_it_away) {
    flow_at(10, 22, 2, 8);
    const std::string hit =
        "The house with the greatest load was hit from the north, by a flow up to 2.0 m deep.";
    slab_ = {0.832, {0, 0.01}, 3000};
    EXPECT_EQ(text(), hit) << "no tool does";
    goal_.tools.emplace_back().kind = sim::CommandKind::kBlast;
    EXPECT_EQ(text(), hit + " When the slope let go, 83 % of its cover was still there.");
    slab_->aside = {-0.2, 0.01};
    EXPECT_EQ(text(), hit +
                          " When the slope let go, 83 % of its cover was still there, more in the west than "
                          "elsewhere.");
    slab_->left = 0.999;
    EXPECT_EQ(text(), hit + " When the slope let go, all of its cover was still there.");
    slab_->load = 9000;
    EXPECT_EQ(text(), hit + " That was before the slope let go.");
}

// A slope that a charge has emptied in the east before the scene lets go of it.
TEST(AttemptWatch, looks_at_the_last_slab_at_the_start_of_its_tick) {
    support::Play play{support::Ground({kHouseVertices, kHouseVertices, kHouseCell}),
                       support::loose_dry_snow()};
    for (int y = 0; y < kHouseVertices; ++y)
        for (int x = 0; x < kHouseVertices; ++x) play.state.depth(x, y) = 2;
    TimedCommand first{2, {}}, last{5, {}}, other{9, {}};
    first.command.kind = last.command.kind = sim::CommandKind::kBlast;
    other.command.kind = sim::CommandKind::kPour;
    last.command.x = last.command.y = 200, last.command.radius = 60;
    Goal goal;
    goal.events = {first, last, other};
    AttemptWatch watch(goal, play.state);
    for (play.state.tick = 1; play.state.tick < 5; ++play.state.tick) watch.see(play.state, false);
    EXPECT_FALSE(watch.slab());
    for (int y = 0; y < kHouseVertices; ++y)
        for (int x = 21; x < kHouseVertices; ++x) play.state.depth(x, y) = 0;
    watch.see(play.state, false);
    ASSERT_TRUE(watch.slab());
    // Of the 113 vertices of the disc 13 lie in its middle column, and 50 on either side.
    EXPECT_NEAR(watch.slab()->left, 63.0 / 113, 1e-12);
    EXPECT_LT(watch.slab()->aside.x, -0.3);
    EXPECT_NEAR(watch.slab()->aside.y, 0, 1e-12);
    EXPECT_EQ(watch.slab()->load, 0);
    ++play.state.tick;
    play.state.depth(15, 20) = 0;
    watch.see(play.state, false);
    EXPECT_NEAR(watch.slab()->left, 63.0 / 113, 1e-12) << "only once";
}

TEST_F(Advice, is_none_where_no_house_counts_or_none_stands) {
    flow_at(9, 21, 2, 8);
    goal_.needs.front().quantity.measure = Measure::kDeposit;
    EXPECT_EQ(text(), "");
    goal_.needs.front().quantity.measure = Measure::kLoad;
    score_.needs.front().met = true;
    EXPECT_EQ(text(), "") << "what was missed is another need";
    score_.needs.front().met = false;
    EXPECT_NE(text(), "");
    play_.state.things->list.clear();
    EXPECT_EQ(text(), "");
}

}  // namespace
}  // namespace game::test
