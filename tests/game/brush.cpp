#include "game/controls/hand.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "game/scene/scenario.h"
#include "sim/world/things.h"

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
    Stroke stroke(Tool::kPour, {}, {10, 20});
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
    Stroke resting(Tool::kPour, {}, {0, 0}), moving(Tool::kPour, {}, {0, 0});
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
    Stroke stroke(Tool::kPour, {}, {0, 0});
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
    Stroke stroke(Tool::kDig, {}, {0, 0});
    const auto commands = draw(stroke, brush, {{5000, 0}}, 1);
    ASSERT_EQ(commands.size(), 1u);
    EXPECT_EQ(commands[0].x, 5000);
}

TEST(Stroke, rests_while_the_hand_is_off_the_ground_and_goes_on_where_it_comes_back) {
    Brush brush;
    Stroke stroke(Tool::kPour, {}, {0, 0});
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
    Stroke stroke(Tool::kBlast, {}, {0, 0});
    std::vector<glm::dvec2> way(20, glm::dvec2(0, 0));  // held still for a while
    for (int i = 1; i <= 25; ++i) way.emplace_back(i, 0);
    const auto commands = draw(stroke, brush, way, 1);
    ASSERT_EQ(commands.size(), 3u);
    EXPECT_EQ(commands[0].x, 0);
    EXPECT_EQ(commands[1].x, 10);
    EXPECT_EQ(commands[2].x, 20);
    EXPECT_EQ(commands[0].depth, brush.own()[0]);
    for (const sim::Command& c : commands) EXPECT_FALSE(sim::fault_of(c));
}

constexpr Modifiers kControlHeld{.control = true}, kShiftHeld{.shift = true};

TEST(Tools, do_the_opposite_with_control_and_smooth_earth_with_shift) {
    using sim::CommandKind;
    const auto kind = [](Tool tool, Modifiers with) { return deed_of(tool, with).kind; };
    EXPECT_EQ(kind(Tool::kPour, {}), CommandKind::kPour);
    EXPECT_EQ(kind(Tool::kPour, kControlHeld), CommandKind::kDig);
    EXPECT_EQ(kind(Tool::kDig, {}), CommandKind::kDig);
    EXPECT_EQ(kind(Tool::kDig, kControlHeld), CommandKind::kPour);
    EXPECT_EQ(kind(Tool::kBlast, kControlHeld), CommandKind::kSettle);
    EXPECT_EQ(kind(Tool::kSculpt, {}), CommandKind::kSculpt);
    EXPECT_EQ(deed_of(Tool::kSculpt, kControlHeld).amount, Amount::kTakenPerTick);
    EXPECT_EQ(kind(Tool::kSculpt, kShiftHeld), CommandKind::kSmooth);
    EXPECT_EQ(kind(Tool::kLevel, kShiftHeld), CommandKind::kSmooth);
    EXPECT_EQ(kind(Tool::kPlant, kControlHeld), CommandKind::kFell);
    EXPECT_EQ(kind(Tool::kWater, {}), CommandKind::kWet);
    EXPECT_EQ(kind(Tool::kWater, kControlHeld), CommandKind::kDrain);
    for (const Tool tool : {Tool::kHouse, Tool::kNet, Tool::kRoad, Tool::kLift})
        EXPECT_EQ(kind(tool, kControlHeld), CommandKind::kRemove);
}

TEST(Tools, reach_every_command_but_those_of_parameters_turning_and_weather) {
    constexpr sim::CommandKind kWithout[] = {sim::CommandKind::kSet,         sim::CommandKind::kTurn,
                                             sim::CommandKind::kStorm,       sim::CommandKind::kWind,
                                             sim::CommandKind::kTemperature, sim::CommandKind::kCancel};
    std::set<sim::CommandKind> kinds;
    for (const ToolInfo& info : tool_infos())
        for (const Deed* deed : {info.plain, info.control, info.shift}) kinds.insert(deed->kind);
    for (const sim::CommandInfo& info : sim::kCommands)
        EXPECT_EQ(kinds.contains(info.kind), std::ranges::find(kWithout, info.kind) == std::end(kWithout))
            << info.name;
}

TEST(Tools, have_numbers_within_the_range_of_their_commands) {
    for (const ToolInfo& info : tool_infos())
        for (const ToolNumber& number : info.numbers) {
            EXPECT_LE(number.least, number.usual) << number.label;
            EXPECT_LE(number.usual, number.most) << number.label;
            EXPECT_TRUE(takes(info.plain->kind, number.member)) << info.plain->label << " " << number.label;
        }
}

// Every deed at the ends of its ranges, on a way that is long enough for lines.
TEST(Stroke, gives_commands_in_range_at_every_size_and_strength) {
    for (const ToolInfo& info : tool_infos())
        for (const Modifiers with : {Modifiers{}, kControlHeld, kShiftHeld})
            for (const double radius : {Brush::kLeastRadius, 1.0, Brush::kMostRadius})
                for (const bool most : {false, true}) {
                    Brush brush;
                    brush.tool = info.tool;
                    brush.radius = radius;
                    for (std::size_t i = 0; i < info.numbers.size(); ++i)
                        brush.own()[i] = most ? info.numbers[i].most : info.numbers[i].least;
                    brush.least_slope = 30, brush.most_slope = 45;
                    Stroke stroke(info.tool, with, {0, 0}, 1234, 5);
                    const char* label = stroke.deed().label;
                    auto commands = draw(stroke, brush, {{1, 1}, {40, 30}}, 2);
                    stroke.move_to(glm::dvec2(90, 30));
                    stroke.release();
                    stroke.commands_of(0, 1, brush, kTick, commands);
                    EXPECT_FALSE(commands.empty()) << label;
                    for (const sim::Command& c : commands) {
                        EXPECT_FALSE(sim::fault_of(c)) << label << ": " << *sim::fault_of(c);
                        if (sim::info_of(c.kind).has_slope) {
                            EXPECT_EQ(c.least_slope, 30) << label;
                        }
                    }
                }
}

TEST(Stroke, sculpts_by_time_up_and_with_control_down) {
    Brush brush;
    brush.tool = Tool::kSculpt;
    for (const bool down : {false, true}) {
        Stroke stroke(Tool::kSculpt, {.control = down}, {50, 50});
        const auto commands = draw(stroke, brush, {{50, 50}}, 60);
        double sum = 0;
        for (const sim::Command& c : commands) sum += c.rise;
        EXPECT_NEAR(sum, down ? -brush.own()[0] : brush.own()[0], 1e-9);  // a second of it
    }
}

// As deep as the disc is wide or narrow.
TEST(Stroke, waters_by_depth_and_with_control_drains) {
    for (const bool drains : {false, true})
        for (const double radius : {5.0, 40.0}) {
            Brush brush;
            brush.tool = Tool::kWater;
            brush.radius = radius;
            Stroke stroke(Tool::kWater, {.control = drains}, {50, 50});
            const auto commands = draw(stroke, brush, {{50, 50}}, 60);
            EXPECT_NEAR(volume(commands), brush.own()[0], 1e-9);  // a second of it
            for (const sim::Command& c : commands) {
                EXPECT_EQ(c.kind, drains ? sim::CommandKind::kDrain : sim::CommandKind::kWet);
                EXPECT_EQ(c.radius, radius);
                EXPECT_EQ(c.duration, kTick);
            }
        }
}

// n d = 1 m of water in soil 2.5 m deep.
TEST(Tools, fill_soil_of_two_and_a_half_metres_in_five_to_twenty_seconds) {
    const ToolNumber& rate = info_of(Tool::kWater).numbers[0];
    EXPECT_GE(sim::kPorosity * 2.5 / rate.usual, 5);
    EXPECT_LE(sim::kPorosity * 2.5 / rate.usual, 20);
}

TEST(Tools, have_water_where_soil_has_friction_and_a_challenge_allows_it) {
    Scenario scenario;
    sim::State state;
    const auto water = [&] { return is_offered(info_of(Tool::kWater), scenario, state); };
    EXPECT_FALSE(water()) << "of an unknown density";
    state.params.density = 300;
    EXPECT_FALSE(water()) << "snow";
    state.params.density = 1800;
    EXPECT_TRUE(water());
    state.params.model = sim::Model::kVoellmy;
    EXPECT_TRUE(water());
    state.params.model = sim::Model::kBcre;
    EXPECT_FALSE(water()) << "without friction";
    state.params.model = sim::Model::kBcreInertial;
    scenario.goal.emplace();
    EXPECT_FALSE(water()) << "no tool of the challenge";
    Goal::Tool tool;
    tool.kind = sim::CommandKind::kWet;
    scenario.goal->tools = {tool};
    EXPECT_TRUE(water());
    EXPECT_FALSE(is_offered(info_of(Tool::kPour), scenario, state));
    EXPECT_FALSE(is_offered(info_of(Tool::kDrain), scenario, state));
    scenario.goal->tools.front().kind = sim::CommandKind::kDrain;
    EXPECT_TRUE(is_offered(info_of(Tool::kDrain), scenario, state));
    EXPECT_FALSE(water());
}

TEST(Stroke, levels_at_the_height_where_it_began) {
    Brush brush;
    brush.tool = Tool::kLevel;
    Stroke stroke(Tool::kLevel, {}, {0, 0}, 1812.5);
    for (const sim::Command& c : draw(stroke, brush, {{0, 0}, {30, 0}}, 2)) EXPECT_EQ(c.level, 1812.5);
}

TEST(Stroke, places_one_house_and_turns_it_with_the_hand) {
    Brush brush;
    brush.tool = Tool::kHouse;
    Stroke stroke(Tool::kHouse, {}, {100, 100}, 0, 5);
    auto commands = draw(stroke, brush, {{100, 100}, {101, 100}, {120, 100}, {120, 100}, {100, 60}}, 3);
    ASSERT_EQ(commands.size(), 3u);
    EXPECT_EQ(commands[0].kind, sim::CommandKind::kHouse);
    EXPECT_EQ(commands[0].turn, 0);
    EXPECT_EQ(commands[1].kind, sim::CommandKind::kTurn);
    EXPECT_EQ(commands[1].turn, 90);
    EXPECT_EQ(commands[2].turn, 180);
    for (const sim::Command& c : commands) {
        EXPECT_EQ(c.x, 100);
        EXPECT_FALSE(sim::fault_of(c)) << *sim::fault_of(c);
    }
    EXPECT_EQ(stroke.turn(), 180);
}

TEST(Stroke, draws_a_road_in_pieces_that_hang_together_and_a_lift_in_one) {
    for (const Tool tool : {Tool::kRoad, Tool::kLift}) {
        Brush brush;
        brush.tool = tool;
        Stroke stroke(tool, {}, {0, 0}, 0, 5);
        std::vector<glm::dvec2> way;
        for (int i = 0; i <= 50; ++i) way.emplace_back(2 * i, 0);
        auto commands = draw(stroke, brush, way, 1);
        stroke.release();
        stroke.commands_of(0, 2, brush, kTick, commands);
        stroke.commands_of(1, 2, brush, kTick, commands);  // nothing is left for it
        ASSERT_EQ(commands.size(), tool == Tool::kRoad ? 5u : 1u);
        double from = 0;
        for (const sim::Command& c : commands) {
            EXPECT_EQ(c.x, from);
            from = c.to_x;
        }
        EXPECT_EQ(from, 100);
    }
}

TEST(Hand, keeps_sizes_within_their_ranges_and_the_turn_of_the_last_house) {
    const sim::Grid grid{41, 41, 5};
    Hand hand;
    hand.suit(grid);
    EXPECT_EQ(hand.brush().radius, 12.5);
    hand.resize(100, grid);
    EXPECT_EQ(hand.brush().radius, radius_range(grid).most);
    hand.strengthen(-100);
    EXPECT_EQ(hand.brush().own()[0], info_of(Tool::kPour).numbers[0].least);
    hand.choose(Tool::kLift);
    hand.strengthen(1);  // it has none
    hand.choose(Tool::kHouse);
    hand.press({}, {100, 100}, 0, 5);
    hand.move_to(glm::dvec2(140, 100));
    EXPECT_EQ(hand.commands_of(0, 1, kTick, true).size(), 1u);
    hand.release();
    hand.arrive(1);
    EXPECT_FALSE(hand.stroke());
    EXPECT_EQ(hand.brush().turn, 90);
}

TEST(Hand, ends_a_stroke_with_the_tool_that_began_it) {
    Hand hand;
    hand.choose(Tool::kPlant);
    hand.press({}, {0, 0}, 0, 5);
    hand.choose(Tool::kHouse);
    hand.release();
    const auto commands = hand.commands_of(0, 1, kTick, true);
    ASSERT_EQ(commands.size(), 1u);
    EXPECT_EQ(commands[0].kind, sim::CommandKind::kPlant);
    EXPECT_FALSE(sim::fault_of(commands[0]));
}

TEST(Hand, tells_whether_it_would_act_and_changes_nothing_by_that) {
    const auto acts = [](Hand& hand) { return hand.would_act(kTick); };
    Hand hand;
    EXPECT_FALSE(acts(hand));
    hand.choose(Tool::kHouse);
    hand.press({}, {5, 5}, 0, 1);
    hand.move_to(glm::dvec2(5, 5));
    EXPECT_TRUE(acts(hand));
    EXPECT_TRUE(acts(hand));
    EXPECT_EQ(hand.commands_of(0, 1, kTick, true).size(), 1u);
    EXPECT_FALSE(acts(hand)) << "it stands";
    hand.move_to(glm::dvec2(9, 5));
    EXPECT_TRUE(acts(hand)) << "it turns";
    hand.drop();
    hand.choose(Tool::kPour);
    hand.press({}, {5, 5}, 0, 1);
    hand.move_to(std::nullopt);
    EXPECT_FALSE(acts(hand)) << "off the terrain";
    hand.drop();
    ASSERT_FALSE(hand.set_number(sim::Params{}, sim::param_from("exchange_rate").value(), 3));
    EXPECT_FALSE(acts(hand)) << "a parameter waits";
}

TEST(Hand, gives_parameters_to_the_next_tick_alone) {
    Hand hand;
    const sim::Params params;
    EXPECT_FALSE(hand.set_number(params, sim::param_from("exchange_rate").value(), 3));
    EXPECT_TRUE(hand.set_number(params, sim::param_from("friction").value(), -1e9));
    EXPECT_TRUE(hand.commands_of(0, 1, kTick, false).empty());  // not in the past
    EXPECT_EQ(hand.commands_of(0, 1, kTick, true).size(), 1u);
    EXPECT_TRUE(hand.commands_of(0, 1, kTick, true).empty());
    EXPECT_FALSE(hand.drop_numbers());
    EXPECT_FALSE(hand.set_number(params, sim::param_from("exchange_rate").value(), 4));
    EXPECT_TRUE(hand.drop_numbers());
    EXPECT_TRUE(hand.commands_of(0, 1, kTick, true).empty());
}

}  // namespace
}  // namespace game::test
