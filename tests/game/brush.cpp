#include "game/controls/brush.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace game::test {
namespace {

constexpr double kTick = 1.0 / 60;
constexpr double kPi = 3.14159265358979323846;

// All commands of a stroke that moves as `at` says, one place per frame of `ticks` ticks.
std::vector<sim::Command> draw(Stroke& stroke, const Brush& brush, const std::vector<glm::dvec2>& at,
                               int ticks) {
    std::vector<sim::Command> commands;
    for (const glm::dvec2 place : at) {
        stroke.move_to(place);
        for (int tick = 0; tick < ticks; ++tick) stroke.commands_of(tick, ticks, brush, kTick, commands);
        stroke.arrive(1);
    }
    return commands;
}

double volume(const std::vector<sim::Command>& commands) {
    double sum = 0;
    for (const sim::Command& c : commands) sum += c.rate * c.duration;
    return sum;
}

TEST(Stroke, gives_one_command_per_tick_of_a_hand_that_rests) {
    Brush brush;
    brush.radius = 3;
    brush.strength[0] = 2;
    Stroke stroke(sim::CommandKind::kPour, {10, 20});
    const auto commands = draw(stroke, brush, {{10, 20}, {10, 20}}, 3);
    ASSERT_EQ(commands.size(), 6u);
    for (const sim::Command& c : commands) {
        EXPECT_EQ(c.kind, sim::CommandKind::kPour);
        EXPECT_EQ(c.x, 10);
        EXPECT_EQ(c.y, 20);
        EXPECT_EQ(c.radius, 3);
        EXPECT_EQ(c.duration, kTick);
        EXPECT_NEAR(c.rate, 2 * kPi * 9, 1e-9);  // two metres of depth a second on the disc
        EXPECT_FALSE(sim::fault_of(c));
    }
}

TEST(Stroke, fills_the_way_of_a_moving_hand_and_spreads_the_same_amount_along_it) {
    Brush brush;
    brush.radius = 4;
    Stroke resting(sim::CommandKind::kPour, {0, 0}), moving(sim::CommandKind::kPour, {0, 0});
    const auto still = draw(resting, brush, {{0, 0}}, 2);
    const auto along = draw(moving, brush, {{30, 0}}, 2);
    EXPECT_NEAR(volume(along), volume(still), 1e-9);
    EXPECT_GT(along.size(), still.size());
    double before = 0;
    for (const sim::Command& c : along) {
        EXPECT_LE(c.x - before, 2 + 1e-9);  // half a radius
        EXPECT_GT(c.x, before);
        before = c.x;
    }
    EXPECT_NEAR(before, 30, 1e-9);
}

TEST(Stroke, goes_on_from_where_the_machine_got_to) {
    Brush brush;
    brush.radius = 4;
    Stroke stroke(sim::CommandKind::kPour, {0, 0});
    std::vector<sim::Command> commands;
    stroke.move_to(glm::dvec2(12, 0));
    stroke.commands_of(0, 4, brush, kTick, commands);  // one of four ticks, and no time for more
    stroke.arrive(0.25);
    EXPECT_NEAR(commands.back().x, 3, 1e-9);
    commands.clear();
    stroke.commands_of(0, 1, brush, kTick, commands);
    EXPECT_LE(commands.front().x - 3, 2 + 1e-9);
    EXPECT_NEAR(commands.back().x, 12, 1e-9);
}

TEST(Brush, fits_every_grid_within_what_a_command_may_be) {
    for (const sim::Grid& grid : {sim::Grid{3, 3, 1e-3f}, sim::Grid{9, 9, 0.01f}, sim::Grid{161, 161, 12.5f},
                                  sim::Grid{257, 200, 800.f}, sim::Grid{41, 41, 2800.f}}) {
        const RadiusRange range = radius_range(grid);
        EXPECT_LE(range.least, range.most);
        EXPECT_GE(range.least, Brush::kLeastRadius);
        EXPECT_LE(range.most, Brush::kMostRadius);
    }
}

TEST(Stroke, does_not_paint_across_a_valley_that_the_hand_jumped_over) {
    Brush brush;
    brush.radius = 4;
    Stroke stroke(sim::CommandKind::kDig, {0, 0});
    const auto commands = draw(stroke, brush, {{5000, 0}}, 1);
    ASSERT_EQ(commands.size(), 1u);
    EXPECT_EQ(commands[0].x, 5000);
}

TEST(Stroke, rests_while_the_hand_is_off_the_ground_and_goes_on_where_it_comes_back) {
    Brush brush;
    Stroke stroke(sim::CommandKind::kPour, {0, 0});
    std::vector<sim::Command> commands;
    stroke.move_to(std::nullopt);
    stroke.commands_of(0, 1, brush, kTick, commands);
    stroke.arrive(1);
    EXPECT_TRUE(commands.empty());
    stroke.move_to(glm::dvec2(100, 0));
    stroke.commands_of(0, 1, brush, kTick, commands);
    ASSERT_EQ(commands.size(), 1u);
    EXPECT_EQ(commands[0].x, 100);
}

TEST(Stroke, of_blasts_goes_off_at_the_press_and_then_once_a_radius) {
    Brush brush;
    brush.tool = Tool::kBlast;
    brush.radius = 10;
    Stroke stroke(sim::CommandKind::kBlast, {0, 0});
    std::vector<glm::dvec2> way(20, glm::dvec2(0, 0));  // held still for a while
    for (int i = 1; i <= 25; ++i) way.emplace_back(i, 0);
    const auto commands = draw(stroke, brush, way, 1);
    ASSERT_EQ(commands.size(), 3u);
    EXPECT_EQ(commands[0].x, 0);
    EXPECT_EQ(commands[1].x, 10);
    EXPECT_EQ(commands[2].x, 20);
    EXPECT_EQ(commands[0].depth, brush.strength[2]);
    for (const sim::Command& c : commands) EXPECT_FALSE(sim::fault_of(c));
}

TEST(Brush, inverts_each_tool) {
    Brush brush;
    EXPECT_EQ(deed_of(brush, false), sim::CommandKind::kPour);
    EXPECT_EQ(deed_of(brush, true), sim::CommandKind::kDig);
    brush.tool = Tool::kDig;
    EXPECT_EQ(deed_of(brush, false), sim::CommandKind::kDig);
    EXPECT_EQ(deed_of(brush, true), sim::CommandKind::kPour);
    brush.tool = Tool::kBlast;
    EXPECT_EQ(deed_of(brush, false), sim::CommandKind::kBlast);
    EXPECT_EQ(deed_of(brush, true), sim::CommandKind::kSettle);
}

TEST(Stroke, gives_commands_in_range_at_every_size_and_strength) {
    Brush brush;
    for (const double radius : {Brush::kLeastRadius, 1.0, Brush::kMostRadius})
        for (const double strength : {Brush::kLeastStrength, Brush::kMostStrength})
            for (const auto deed : {sim::CommandKind::kPour, sim::CommandKind::kDig, sim::CommandKind::kBlast,
                                    sim::CommandKind::kSettle}) {
                brush.radius = radius;
                brush.strength.fill(strength);
                Stroke stroke(deed, {0, 0});
                for (const sim::Command& c : draw(stroke, brush, {{1, 1}}, 2))
                    EXPECT_FALSE(sim::fault_of(c)) << *sim::fault_of(c);
            }
}

}  // namespace
}  // namespace game::test
