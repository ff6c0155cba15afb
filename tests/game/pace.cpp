#include "game/controls/pace.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/game/camera_hands.h"

namespace game::test {
namespace {

// A state of which so many cubic metres move.
sim::State moving(double cubic_metres) {
    sim::State state = level();
    state.ledger.rolling =
        std::llround(cubic_metres / (static_cast<double>(sim::kQuantum) * state.grid.cell_area()));
    return state;
}

TEST(Pace, lets_an_hour_last_longer_in_a_storm) {
    sim::State state = level();
    state.weather.emplace(sim::Calendar(), state.depth);
    EXPECT_DOUBLE_EQ(shown_seconds(state), 1.0 / 6);
    sim::Command storm;
    storm.kind = sim::CommandKind::kStorm;
    storm.at = 10, storm.hours = 4, storm.precipitation = 8;
    sim::change_program(*state.weather, storm);
    EXPECT_DOUBLE_EQ(shown_seconds(state), 1.0 / 6);
    state.weather->hours = 13;
    EXPECT_DOUBLE_EQ(shown_seconds(state), 1.0 / 2);
    state.weather->hours = 14;
    EXPECT_DOUBLE_EQ(shown_seconds(state), 1.0 / 6);
}

TEST(Pace, slows_for_a_second_where_much_breaks_loose_at_once) {
    Pace pace;
    pace.see(moving(0), 10);
    EXPECT_FALSE(pace.is_moment(10));
    pace.see(moving(5000), 10.1);
    EXPECT_TRUE(pace.is_moment(10.1));
    EXPECT_TRUE(pace.is_moment(11));
    EXPECT_FALSE(pace.is_moment(11.2));
    // It grows, and that is no other release.
    for (int i = 1; i <= 30; ++i) pace.see(moving(5000 + 600 * i), 12);
    EXPECT_FALSE(pace.is_moment(12.1));
    pace.see(moving(60000), 13);
    EXPECT_TRUE(pace.is_moment(13.5));
}

TEST(Pace, slows_for_a_second_at_the_first_hit_of_a_slide_and_not_after_a_jump) {
    const auto hits = [](int houses, double cubic_metres) {
        sim::State state = moving(cubic_metres);
        state.things.emplace(state.grid);
        for (int i = 0; i < 3; ++i) {
            sim::Thing house;
            house.load = i < houses ? 4000 : 900;
            state.things->list.push_back(house);
        }
        return state;
    };
    Pace pace;
    pace.see(hits(1, 400), 10);  // the world is at another time: who knows when that was hit
    EXPECT_FALSE(pace.is_moment(10));
    pace.see(hits(2, 400), 20);
    EXPECT_TRUE(pace.is_moment(20.9));
    pace.see(hits(3, 400), 30);
    EXPECT_FALSE(pace.is_moment(30));
    pace.see(hits(1, 0), 40);
    pace.see(hits(2, 400), 50);  // the next slide
    EXPECT_TRUE(pace.is_moment(50));
}

TEST(Pace, does_not_slow_for_what_a_hand_pours) {
    Pace pace;
    for (int i = 0; i < 50; ++i) pace.see(moving(20.0 * i), i);
    EXPECT_FALSE(pace.is_moment(49.1));
}

TEST(Pace, finds_creep_after_a_slide_but_not_before_one_or_at_rest) {
    Pace pace;
    pace.see(moving(0), 0);
    EXPECT_FALSE(pace.creeps());
    pace.see(moving(50), 1);
    EXPECT_FALSE(pace.creeps());
    pace.see(moving(40000), 2);
    EXPECT_FALSE(pace.creeps());
    pace.see(moving(2000), 3);
    EXPECT_FALSE(pace.creeps());
    pace.see(moving(1000), 4);
    EXPECT_TRUE(pace.creeps());
    sim::State poured = moving(1000);
    poured.running_commands.emplace_back();
    pace.see(poured, 5);
    EXPECT_FALSE(pace.creeps());
    pace.see(moving(0), 6);
    EXPECT_FALSE(pace.creeps());
    pace.see(moving(100), 7);  // another slide, which only begins
    EXPECT_FALSE(pace.creeps());
}

}  // namespace
}  // namespace game::test
