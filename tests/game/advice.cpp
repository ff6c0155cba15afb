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
    std::string text() const { return advice_after(goal_, score_, sim::view(play_.state), peaks_); }

    Goal goal_;
    Score score_;
    support::Play play_{support::Ground({kHouseVertices, kHouseVertices, kHouseCell}),
                        support::loose_dry_snow()};
    Peaks peaks_;
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
