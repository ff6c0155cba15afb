#include "sim/world/things.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/load_things.h"
#include "sim/simd/instruction_set.h"
#include "sim/world/quanta.h"
#include "sim/world/snapshot.h"
#include "sim/world/state_hash.h"
#include "sim/world/thing_places.h"
#include "tests/support/worlds.h"

namespace {

using sim::Command;
using sim::CommandKind;
using sim::Model;
using support::Ground;
using support::Play;

constexpr float kSnow = 300;  // kg/m³

// Level ground with snow that flows without friction.
Ground level(int squares, float dx, double rolling) {
    Ground ground = support::plane(squares, dx, 0);
    ground.set(ground.rolling, [&](double, double) { return rolling; });
    ground.density = kSnow;
    return ground;
}

sim::Params frictionless(Model model) {
    sim::Params params;
    params.model = model;
    params.friction = params.friction_thin = 0;
    params.drag = 1e6f;
    return params;
}

void set_velocity(sim::State& s, float u) {
    for (int y = 0; y < s.grid.ny; ++y) std::fill(s.velocity_x.row(y), s.velocity_x.row(y) + s.grid.nx, u);
}

Command at(CommandKind kind, double x, double y, double radius = Command().radius) {
    Command c;
    c.kind = kind;
    c.x = x, c.y = y, c.radius = radius;
    return c;
}

Command house(double x, double y, double strength, double size = 10) {
    Command c = at(CommandKind::kHouse, x, y);
    c.length = c.width = size;
    c.height = 6;
    c.strength = strength;
    return c;
}

Command forest(double x, double y, double radius, double stems) {
    Command c = at(CommandKind::kPlant, x, y, radius);
    c.stems = stems, c.diameter = 0.3, c.height = 22;
    return c;
}

Command sculpting(CommandKind kind, double x, double y, double radius, double rise) {
    Command c = at(kind, x, y, radius);
    c.rise = rise;
    return c;
}

Command line(CommandKind kind, double x, double y, double to_x, double to_y) {
    Command c = at(kind, x, y);
    c.to_x = to_x, c.to_y = to_y;
    if (kind == CommandKind::kNet) c.height = 3, c.strength = 30;
    if (kind == CommandKind::kRoad) c.width = 8;
    return c;
}

double cubic_metres(const sim::State& s, std::int64_t quanta) {
    return static_cast<double>(quanta) * static_cast<double>(sim::kQuantum) * s.grid.cell_area();
}

TEST(Forest, slows_a_flow_by_its_stems_alone) {
    Ground ground = level(80, 5, 1);
    Play play(ground, frictionless(Model::kVoellmy));
    const Command planted = forest(200, 200, 1000, 400);
    sim::apply_commands(play.state, {&planted, 1});
    set_velocity(play.state, 20);
    double way = 0;
    for (int i = 0; i < 120; ++i) {
        play.ticks(1);
        way += static_cast<double>(play.state.velocity_x(40, 40)) / 60;
    }
    // v = v0/(1 + .009 v0 t), and the way is ln(1 + .009 v0 t)/.009.
    EXPECT_NEAR(static_cast<double>(play.state.velocity_x(40, 40)), 14.7059, 0.01);
    EXPECT_NEAR(way, 34.16, 0.06);
}

TEST(Forest, catches_snow_at_the_rate_of_its_stems_and_loses_no_quantum) {
    Ground ground = level(40, 5, 1);
    Play play(ground, frictionless(Model::kBcreInertial));
    const Command planted = forest(100, 100, 1000, 400);
    sim::apply_commands(play.state, {&planted, 1});
    set_velocity(play.state, 5);
    const std::int64_t before = play.state.ledger.initial;
    double expected = 0;
    for (int i = 0; i < 30; ++i) {
        play.ticks(1);
        expected += 25 / (300 * static_cast<double>(play.state.velocity_x(20, 20))) / 60;
    }
    EXPECT_NEAR(static_cast<double>(play.state.depth(20, 20)), expected, 0.02 * expected);
    EXPECT_EQ(play.state.ledger.standing + play.state.ledger.rolling + play.state.ledger.out, before);
}

TEST(Forest, breaks_at_its_bending_moment) {
    for (const auto& [pressure_kpa, breaks] : {std::pair{87.0, false}, {89.0, true}}) {
        Ground ground = level(20, 5, 2);
        Play play(ground, frictionless(Model::kVoellmy));
        const Command planted = forest(50, 50, 3, 400);
        sim::apply_commands(play.state, {&planted, 1});
        set_velocity(play.state, static_cast<float>(std::sqrt(1000 * pressure_kpa / 300)));
        sim::load_things(play.state);
        const sim::Stems& stems = play.state.things->forest(10, 10);
        EXPECT_EQ(stems.standing, breaks ? 0 : 400);
        EXPECT_EQ(stems.lying, breaks ? 400 : 0);
        EXPECT_EQ(play.state.things->drag(10, 10) == 0, breaks);
        EXPECT_EQ(play.state.things->hold(10, 10) == 0, breaks);
    }
}

TEST(Forest, breaks_alike_with_and_without_sleeping_tiles) {
    Ground ground = support::plane(160, 5, 0.5);
    ground.density = kSnow;
    ground.forest.assign(ground.grid.size(), {400, 0, 30, 22});
    ground.set(ground.rolling,
               [](double x, double y) { return std::hypot(x - 300, y - 60) < 40 ? 4.0 : 0.0; });
    const sim::Params params = support::lively(Model::kBcreInertial);
    Play sleeping(ground, params, {.tile_width = 32, .tile_height = 16}),
        awake(ground, params, {.tile_width = 32, .tile_height = 16, .tiles_may_sleep = false});
    set_velocity(sleeping.state, 20), set_velocity(awake.state, 20);
    for (int tick = 0; tick < 300; ++tick) {
        sleeping.ticks(1), awake.ticks(1);
        ASSERT_EQ(sim::state_hash(sleeping.state), sim::state_hash(awake.state)) << tick;
    }
    const auto broken = [](const sim::Stems& stems) { return stems.lying > 0; };
    const sim::Field<sim::Stems>& forest = sleeping.state.things->forest;
    std::ptrdiff_t count = 0;
    for (int y = 0; y <= 160; ++y) count += std::count_if(forest.row(y), forest.row(y) + 161, broken);
    EXPECT_GT(count, 20);
    const auto& tiles = sleeping.state.tiles.awake;
    EXPECT_GT(std::count(tiles.begin(), tiles.end(), 0), 10);
}

TEST(Forest, holds_what_a_blast_would_release) {
    for (const auto& [stems, share] : {std::pair{0.0, 1.0}, {200.0, 0.5}, {400.0, 0.0}, {800.0, 0.0}}) {
        Play play(support::plane(20, 5, 0.3, 2), frictionless(Model::kBcreInertial));
        std::vector<Command> commands;
        if (stems > 0) commands.push_back(forest(50, 50, 40, stems));
        Command blast = at(CommandKind::kBlast, 50, 50, 20);
        blast.depth = 1;
        commands.push_back(blast);
        sim::apply_commands(play.state, commands);
        EXPECT_EQ(play.state.rolling(10, 10), static_cast<float>(share)) << stems;
    }
}

// What a house of this strength becomes when a layer of this thickness passes with this pressure.
sim::Thing struck(double strength, double rolling, double pressure_kpa) {
    Ground ground = level(20, 10, rolling);
    ground.placed = {house(100, 100, strength)};
    Play play(ground, frictionless(Model::kVoellmy));
    set_velocity(play.state, static_cast<float>(std::sqrt(1000 * pressure_kpa / 300)));
    sim::load_things(play.state);
    return play.state.things->list.front();
}

TEST(House, is_damaged_from_half_of_its_strength_on_and_destroyed_from_all_of_it) {
    EXPECT_FALSE(struck(10, 1, 4.9).damaged());
    EXPECT_TRUE(struck(10, 1, 5.1).damaged());
    EXPECT_FALSE(struck(10, 1, 9.9).destroyed());
    EXPECT_TRUE(struck(10, 1, 10.1).destroyed());
    EXPECT_FALSE(struck(10, 3, 9.9).destroyed());
    EXPECT_TRUE(struck(10, 3, 10.1).destroyed());
}

TEST(House, feels_a_thin_layer_as_far_as_it_reaches) {
    EXPECT_FALSE(struck(10, 0.5, 19.7).destroyed());
    EXPECT_TRUE(struck(10, 0.5, 20.3).destroyed());
    const sim::Thing wood = struck(5, 0.02, 120);
    EXPECT_FALSE(wood.damaged());
    EXPECT_NEAR(static_cast<double>(wood.load), 2400, 20);
}

TEST(House, remembers_its_greatest_load_and_how_deep_it_was_buried) {
    Ground ground = level(20, 10, 2);
    ground.placed = {house(100, 100, 100)};
    Play play(ground, frictionless(Model::kVoellmy));
    set_velocity(play.state, 10);
    sim::load_things(play.state);
    const std::int64_t load = play.state.things->list.front().load;
    EXPECT_NEAR(static_cast<double>(load), 30000, 30);
    set_velocity(play.state, 3);
    sim::load_things(play.state);
    EXPECT_EQ(play.state.things->list.front().load, load);
    EXPECT_EQ(play.state.things->list.front().buried, 2000);
    EXPECT_FALSE(play.state.things->list.front().under());
}

TEST(House, that_is_two_cells_wide_is_ground_and_falls_to_rubble_under_what_lies_on_it) {
    Ground ground = level(40, 5, 0);
    ground.set(ground.depth, [](double, double) { return 0.5; });
    ground.set(ground.rolling, [](double x, double) { return x < 80 ? 2.0 : 0.0; });
    ground.placed = {house(100, 100, 5, 20)};
    Play play(ground, frictionless(Model::kBcreInertial));
    EXPECT_EQ(play.state.bedrock(20, 20), 6);
    EXPECT_EQ(play.state.bedrock(10, 20), 0);
    set_velocity(play.state, 15);
    const std::int64_t all = play.state.ledger.initial;
    for (int i = 0; i < 300 && !play.state.things->list.front().destroyed(); ++i) play.ticks(1);
    ASSERT_TRUE(play.state.things->list.front().destroyed());
    EXPECT_EQ(play.state.bedrock(20, 20), 1);
    play.ticks(60);
    EXPECT_EQ(play.state.ledger.mass_error(), 0);
    EXPECT_EQ(play.state.ledger.standing + play.state.ledger.rolling + play.state.ledger.out, all);
}

TEST(House, turned_acts_where_it_then_stands) {
    Ground ground = level(40, 5, 0);
    Command barn = house(100, 100, 5, 12);
    barn.length = 60;
    ground.placed = {barn};
    Play play(ground, frictionless(Model::kVoellmy));
    EXPECT_EQ(play.state.bedrock(20, 25), 6);
    EXPECT_EQ(play.state.bedrock(25, 20), 0);
    Command turn = at(CommandKind::kTurn, 100, 100);
    turn.turn = 90;
    play.ticks(1, {&turn, 1});
    EXPECT_EQ(play.state.bedrock(20, 25), 0);
    EXPECT_EQ(play.state.bedrock(25, 20), 6);
}

TEST(Lift, has_a_station_at_either_end_and_pylons_between) {
    Ground ground = level(40, 10, 0);
    ground.placed = {line(CommandKind::kLift, 50, 50, 50, 290)};
    const Play play(ground, frictionless(Model::kVoellmy));
    const auto& list = play.state.things->list;
    ASSERT_EQ(list.size(), 4u);
    EXPECT_EQ(list[0].kind, sim::ThingKind::kStation);
    EXPECT_EQ(list[1].kind, sim::ThingKind::kPylon);
    EXPECT_EQ(list[3].kind, sim::ThingKind::kStation);
    EXPECT_DOUBLE_EQ(list[1].y, 130);
    EXPECT_EQ(list[0].group, list[3].group);
}

TEST(Nets, hold_the_strip_above_them_as_far_as_they_are_high_and_fall_piece_by_piece) {
    // 40 degrees down to the north; 3 m nets hold 17 m.
    Ground ground = support::plane(40, 5, 0.8391, 2);
    ground.density = kSnow;
    ground.placed = {line(CommandKind::kNet, 80, 100, 120, 100)};
    Play play(ground, frictionless(Model::kBcreInertial));
    sim::Things& things = *play.state.things;
    EXPECT_EQ(things.list.size(), 8u);
    EXPECT_EQ(sim::held_share(things, 20, 20, 2), 1);
    EXPECT_EQ(sim::held_share(things, 20, 17, 2), 1);
    EXPECT_EQ(sim::held_share(things, 20, 15, 2), 0);
    EXPECT_EQ(sim::held_share(things, 20, 22, 2), 0);
    EXPECT_EQ(sim::held_share(things, 20, 20, 3.1f), 0) << "snow deeper than the nets";
    for (const auto& [pressure_kpa, falls] : {std::pair{29.9, false}, {30.1, true}}) {
        play.state.rolling(20, 20) = 2;
        play.state.velocity_x(20, 20) = static_cast<float>(std::sqrt(1000 * pressure_kpa / 300));
        sim::load_things(play.state);
        const auto fallen = std::count_if(things.list.begin(), things.list.end(),
                                          [](const sim::Thing& piece) { return piece.destroyed(); });
        EXPECT_EQ(fallen > 0, falls);
        EXPECT_LT(fallen, 8);
    }
    EXPECT_EQ(sim::held_share(things, 20, 17, 2), 0);
    EXPECT_EQ(sim::held_share(things, 17, 17, 2), 1);
}

TEST(Things, that_cannot_stand_are_refused_with_what_is_in_their_way) {
    Ground ground = level(20, 10, 0);
    ground.has_data[ground.at(15, 15)] = 0;
    ground.placed = {house(50, 50, 5)};
    const Play play(ground, frictionless(Model::kVoellmy));
    const auto fault = [&](std::vector<Command> commands) {
        return sim::fault_of_things(play.state, commands).value_or(sim::ThingFault{});
    };
    EXPECT_EQ(fault({house(120, 50, 5)}).fact, "");
    EXPECT_NE(fault({house(55, 55, 5)}).fact.find("house at (50, 50)"), std::string::npos);
    EXPECT_EQ(fault({house(120, 50, 5), house(125, 50, 5)}).command, 1u);
    EXPECT_NE(fault({house(199, 50, 5)}).fact.find("outside the terrain"), std::string::npos);
    EXPECT_NE(fault({house(150, 150, 5)}).fact.find("no data"), std::string::npos);
    EXPECT_NE(fault({line(CommandKind::kRoad, 20, 100, 300, 100)}).fact.find("outside"), std::string::npos);
    EXPECT_NE(fault({line(CommandKind::kNet, 20, 100, 20, 100)}).fact.find("0 m long"), std::string::npos);
    EXPECT_NE(fault({line(CommandKind::kLift, 20, 100, 60, 100)}).fact.find("40 m long"), std::string::npos);
    EXPECT_NE(fault({at(CommandKind::kRemove, 150, 50, 20)}).fact.find("nothing"), std::string::npos);
    EXPECT_NE(fault({at(CommandKind::kTurn, 150, 50)}).fact.find("no house"), std::string::npos);
    EXPECT_EQ(fault({at(CommandKind::kRemove, 50, 50, 1), house(55, 55, 5)}).fact, "");
    std::vector<Command> roads(sim::kMostThings, line(CommandKind::kRoad, 20, 100, 40, 100));
    EXPECT_EQ(fault(roads).command, sim::kMostThings - 1);
}

TEST(Things, that_are_removed_leave_the_world_as_it_was) {
    Ground ground = support::rough(40, 5, 3);
    ground.density = kSnow;
    ground.set(ground.rolling, [](double, double) { return 0.0; });
    Play touched(ground, support::lively(Model::kBcreInertial)),
        never(ground, support::lively(Model::kBcreInertial));
    const std::vector<Command> placed{house(100, 100, 5, 20), forest(50, 50, 30, 300),
                                      sculpting(CommandKind::kSculpt, 150, 50, 20, 3)};
    sim::apply_commands(touched.state, placed);
    EXPECT_NE(sim::state_hash(touched.state), sim::state_hash(never.state));
    const std::vector<Command> removed{at(CommandKind::kRemove, 100, 100, 1),
                                       at(CommandKind::kFell, 50, 50, 30),
                                       sculpting(CommandKind::kSculpt, 150, 50, 20, -3)};
    sim::apply_commands(touched.state, removed);
    EXPECT_EQ(sim::state_hash(touched.state), sim::state_hash(never.state));
    EXPECT_TRUE(support::same_bits(touched.state.bedrock, never.state.bedrock));
}

TEST(Earth, is_built_as_far_as_its_budget_reaches_and_then_refused) {
    Ground ground = level(40, 5, 0);
    ground.earth_budget = 100;
    Play play(ground, frictionless(Model::kVoellmy));
    const Command stroke = sculpting(CommandKind::kSculpt, 100, 100, 12, 2);
    ASSERT_FALSE(sim::fault_of_things(play.state, {&stroke, 1}));
    play.ticks(1, {&stroke, 1});
    EXPECT_NEAR(cubic_metres(play.state, sim::earth_used(*play.state.things)), 100, 1e-3);
    EXPECT_LE(sim::earth_used(*play.state.things), play.state.things->budget);
    const std::uint64_t hash = sim::state_hash(play.state);
    const auto fault = sim::fault_of_things(play.state, {&stroke, 1});
    ASSERT_TRUE(fault);
    EXPECT_NE(fault->fact.find(" 100 m3"), std::string::npos);
    sim::apply_commands(play.state, {&stroke, 1});
    EXPECT_EQ(sim::state_hash(play.state), hash) << "not a quantum is left";
    const Command lower = sculpting(CommandKind::kSculpt, 100, 100, 12, -0.5);
    EXPECT_FALSE(sim::fault_of_things(play.state, {&lower, 1})) << "what gives earth back is allowed";
}

TEST(Earth, that_is_cut_fills_elsewhere) {
    Ground ground = level(40, 5, 0);
    Play play(ground, frictionless(Model::kVoellmy));
    const std::vector<Command> strokes{sculpting(CommandKind::kSculpt, 60, 60, 0, 1),
                                       sculpting(CommandKind::kSculpt, 120, 120, 0, -1),
                                       sculpting(CommandKind::kSculpt, 150, 120, 0, -0.5)};
    const sim::Snapshot before = sim::take_snapshot(play.state);
    sim::apply_commands(play.state, strokes);
    const sim::Snapshot after = sim::take_snapshot(play.state);
    const auto used = [&] { return cubic_metres(play.state, sim::earth_used(*play.state.things)); };
    EXPECT_DOUBLE_EQ(used(), 1.5 * 25);
    EXPECT_EQ(sim::earth_used(*play.state.things), sim::moved_in(play.state.things->earth).used());
    sim::restore(before, play.state);
    EXPECT_EQ(used(), 0);
    sim::restore(after, play.state);
    EXPECT_DOUBLE_EQ(used(), 1.5 * 25);
}

TEST(Earth, carries_its_cover_and_keeps_its_flanks) {
    Ground ground = support::plane(40, 5, 0.3, 1);
    Play play(ground, frictionless(Model::kBcreInertial));
    const Command stroke = sculpting(CommandKind::kSculpt, 100, 100, 30, 3);
    for (int i = 0; i < 20; ++i) sim::apply_commands(play.state, {&stroke, 1});
    const sim::Things& things = *play.state.things;
    EXPECT_GT(things.earth(20, 20), 15);
    for (int y = 1; y < 40; ++y)
        for (int x = 1; x < 40; ++x) {
            EXPECT_LE(std::abs(things.earth(x, y) - things.earth(x - 1, y)), 4.001f);
            EXPECT_EQ(play.state.depth(x, y), 1);
        }
}

TEST(Earth, of_one_stroke_is_as_high_as_its_flanks_allow_on_any_grid) {
    const auto top = [](double dx, double radius, double rise) {
        const int squares = static_cast<int>(std::lround(100 / dx));
        Ground ground = level(squares, static_cast<float>(dx), 0);
        Play play(ground, frictionless(Model::kVoellmy));
        Command stroke = sculpting(CommandKind::kSculpt, 50, 50, radius, rise);
        stroke.profile = sim::Profile::kCone;
        sim::apply_commands(play.state, {&stroke, 1});
        return play.state.things->earth(squares / 2, squares / 2);
    };
    for (const double dx : {1.0, 2.5, 5.0}) {
        EXPECT_EQ(top(dx, 20, 8), 8) << dx << ": its flanks are 1 : 2.5";
        EXPECT_EQ(top(dx, 20, -8), -8) << dx;
        EXPECT_NEAR(top(dx, 10, 20), 8, 0.8 * dx) << dx << ": no higher than flanks of 1 : 1.25";
        EXPECT_NEAR(top(dx, 10, -20), -8, 0.8 * dx) << dx;
    }
}

TEST(Earth, is_not_sculpted_under_a_flow) {
    Ground ground = level(40, 5, 0);
    ground.rolling[ground.at(20, 20)] = 1;
    const Play play(ground, frictionless(Model::kVoellmy));
    const Command on = sculpting(CommandKind::kSculpt, 100, 100, 12, 2),
                  beside = sculpting(CommandKind::kSculpt, 150, 100, 12, 2);
    EXPECT_TRUE(sim::fault_of_things(play.state, {&on, 1}));
    EXPECT_FALSE(sim::fault_of_things(play.state, {&beside, 1}));
}

TEST(Earth, is_levelled_and_smoothed) {
    Ground ground = support::rough(40, 5, 7);
    ground.set(ground.rolling, [](double, double) { return 0.0; });
    Play play(ground, support::lively(Model::kBcreInertial));
    Command level_it = sculpting(CommandKind::kLevel, 100, 100, 10, 2);
    level_it.level = static_cast<double>(play.state.bedrock(20, 20)) + 0.5;
    sim::apply_commands(play.state, {&level_it, 1});
    EXPECT_NEAR(static_cast<double>(play.state.bedrock(20, 20)), level_it.level, 1e-4);
    const auto bend = [&] {
        const auto& b = play.state.bedrock;
        return std::abs(b(19, 20) + b(21, 20) + b(20, 19) + b(20, 21) - 4 * b(20, 20));
    };
    const float before = bend();
    const Command smooth = sculpting(CommandKind::kSmooth, 100, 100, 20, 2);
    for (int i = 0; i < 5; ++i) sim::apply_commands(play.state, {&smooth, 1});
    EXPECT_LT(bend(), 0.5f * before);
}

TEST(Commands, act_only_on_slopes_that_they_take) {
    Ground ground = support::plane(40, 5, 0, 1);
    ground.set(ground.bedrock,
               [](double x, double) { return x < 100 ? 0.0 : 0.7 * (x - 100); });  // 35 degrees
    Play play(ground, frictionless(Model::kBcreInertial));
    Command blast = at(CommandKind::kBlast, 100, 100, 60);
    blast.depth = 0.5;
    blast.least_slope = 30, blast.most_slope = 45;
    sim::apply_commands(play.state, {&blast, 1});
    EXPECT_EQ(play.state.rolling(14, 20), 0);
    EXPECT_EQ(play.state.rolling(26, 20), 0.5f);
}

// A rough slope with some of everything on it, and flows that reach it.
Ground inhabited(unsigned seed) {
    Ground ground = support::rough(60, 5, seed);
    ground.density = kSnow;
    std::mt19937 random(seed);
    const auto place = [&] { return 40 + 220 * (static_cast<double>(random()) / 4294967296.0); };
    ground.placed = {house(150, 120, 5, 24), house(60, 200, 30, 8), line(CommandKind::kLift, 40, 40, 40, 260),
                     line(CommandKind::kNet, 90, 150, 200, 160), line(CommandKind::kRoad, 20, 250, 280, 260)};
    for (int i = 0; i < 6; ++i) ground.placed.push_back(forest(place(), place(), 30, 100.0 * (i + 1)));
    for (int i = 0; i < 6; ++i)
        ground.placed.push_back(sculpting(i % 2 ? CommandKind::kSculpt : CommandKind::kSmooth, place(),
                                          place(), 25, i % 3 ? 3 : 6));
    return ground;
}

TEST(Things, act_alike_in_plain_step_and_sweep_on_any_threads_and_lanes) {
    for (const Model model : {Model::kBcre, Model::kBcreInertial, Model::kVoellmy})
        for (unsigned seed = 1; seed <= 3; ++seed) {
            Ground ground = inhabited(seed);
            ground.set(ground.rolling,
                       [&](double x, double y) { return std::hypot(x - 150, y - 60) < 40 ? 3.0 : 0.0; });
            const sim::Params params = support::lively(model);
            Play plain(ground, params, {.plain = true});
            std::vector<std::unique_ptr<Play>> swept;
            for (const sim::InstructionSet set : sim::kInstructionSets)
                for (const int threads : {1, 3})
                    if (sim::has(set))
                        swept.push_back(std::make_unique<Play>(ground, params,
                                                               sim::StepOptions{.threads = threads,
                                                                                .instruction_set = set,
                                                                                .tile_width = 32,
                                                                                .tile_height = 16}));
            for (int tick = 0; tick < 200; ++tick) {
                plain.ticks(1);
                for (const auto& each : swept) {
                    Play& play = *each;
                    play.ticks(1);
                    ASSERT_EQ(sim::state_hash(play.state), sim::state_hash(plain.state)) << tick;
                    ASSERT_EQ(sim::update_state_hash(play.state, play.engine.workers),
                              sim::state_hash(play.state));
                }
            }
            EXPECT_EQ(plain.state.ledger.mass_error(), 0);
        }
}

TEST(Things, leave_a_world_alone_where_there_are_none) {
    for (const Model model : {Model::kBcre, Model::kBcreInertial, Model::kVoellmy}) {
        Ground ground = support::rough(60, 5, 5);
        // Natural ground of 75 degrees is no wall.
        ground.set(ground.bedrock, [](double x, double y) { return -0.6 * y - (x > 150 ? 20 : 0); });
        Play without(ground, support::lively(model));
        ground.placed = {line(CommandKind::kRoad, 20, 20, 60, 20)};
        Play with(ground, support::lively(model));
        for (int i = 0; i < 120; ++i) {
            without.ticks(1), with.ticks(1);
            ASSERT_TRUE(support::same_bits(with.state.rolling, without.state.rolling)) << i;
            ASSERT_TRUE(support::same_bits(with.state.velocity_x, without.state.velocity_x)) << i;
            ASSERT_TRUE(support::same_bits(with.state.depth, without.state.depth)) << i;
        }
    }
}

TEST(Things, come_back_with_a_snapshot_and_have_the_same_future) {
    Ground ground = inhabited(2);
    Play play(ground, support::lively(Model::kBcreInertial));
    const sim::Snapshot before = sim::take_snapshot(play.state);
    const std::vector<Command> later{at(CommandKind::kRemove, 150, 120, 1), forest(200, 200, 40, 500),
                                     sculpting(CommandKind::kSculpt, 240, 40, 20, 4)};
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 60; ++i) {
        play.ticks(1, i == 10 ? std::span<const Command>(later) : std::span<const Command>{});
        hashes.push_back(sim::update_state_hash(play.state, play.engine.workers));
    }
    sim::restore(before, play.state);
    for (int i = 0; i < 60; ++i) {
        play.ticks(1, i == 10 ? std::span<const Command>(later) : std::span<const Command>{});
        ASSERT_EQ(sim::update_state_hash(play.state, play.engine.workers),
                  hashes[static_cast<std::size_t>(i)])
            << i;
        ASSERT_EQ(sim::state_hash(play.state), hashes[static_cast<std::size_t>(i)]) << i;
    }
}

TEST(Things, come_and_go_with_snapshots_of_a_world_without_any) {
    Ground ground = support::rough(40, 5, 4);
    ground.bedrock[0] = -0.f;  // has other bits than 0
    Play play(ground, support::lively(Model::kBcreInertial));
    play.ticks(3);
    const sim::Snapshot before = sim::take_snapshot(play.state);
    const std::uint64_t hash = sim::state_hash(play.state);
    const Command dam = sculpting(CommandKind::kSculpt, 100, 20, 15, 4);
    play.ticks(5, {&dam, 1});
    sim::restore(before, play.state);
    EXPECT_EQ(sim::state_hash(play.state), hash);
    Play never(ground, support::lively(Model::kBcreInertial));
    never.ticks(3);
    for (int i = 0; i < 40; ++i) {
        play.ticks(1), never.ticks(1);
        ASSERT_EQ(sim::state_hash(play.state), sim::state_hash(never.state)) << i;
    }
}

// Rectangles of any size and direction, also beside the grid.
TEST(Footprint, has_the_vertices_that_a_look_at_the_whole_grid_finds) {
    const sim::Grid grid{61, 47, 3.5f};
    std::mt19937 random(5);
    const auto number = [&](double least, double most) {
        return least +
               (most - least) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    };
    for (int trial = 0; trial < 600; ++trial) {
        const double turn = trial % 3 == 0 ? 90 * (trial % 4) + number(-0.1, 0.1) : number(0, 360);
        const sim::Direction front = sim::direction_of(turn);
        const sim::Thing thing{.x = number(-40, 260),
                               .y = number(-40, 210),
                               .front_x = front.x,
                               .front_y = front.y,
                               .length = number(1, 200),
                               .width = number(1, trial % 2 ? 200 : 8)};
        std::vector<std::int32_t> expected;
        for (int y = 0; y < grid.ny; ++y)
            for (int x = 0; x < grid.nx; ++x) {
                const double east = x * static_cast<double>(grid.dx) - thing.x,
                             north = y * static_cast<double>(grid.dx) - thing.y;
                if (std::abs(east * front.x + north * front.y) <= 0.5 * thing.length &&
                    std::abs(east * front.y - north * front.x) <= 0.5 * thing.width)
                    expected.push_back(y * grid.nx + x);
            }
        const auto found = sim::footprint_of(thing, grid);
        if (expected.empty())
            EXPECT_EQ(found.size(), 1u) << "the nearest one";
        else
            EXPECT_EQ(found, expected) << trial;
    }
}

// What is known from the objects is found once for a row of commands.
TEST(Commands, of_objects_in_a_row_act_as_one_by_one) {
    Ground ground = support::rough(40, 5, 3);
    ground.set(ground.rolling, [](double, double) { return 0.0; });
    const std::vector<Command> commands{
        house(100, 100, 5, 20),
        line(CommandKind::kNet, 20, 150, 60, 160),
        at(CommandKind::kTurn, 100, 100),
        house(60, 60, 5, 4),
        sculpting(CommandKind::kSculpt, 110, 100, 30, 3),  // not under the house
        forest(100, 100, 30, 300),
        line(CommandKind::kLift, 20, 20, 180, 30),
        at(CommandKind::kRemove, 60, 60, 1),
        line(CommandKind::kRoad, 20, 100, 60, 100),
        at(CommandKind::kFell, 110, 100, 10),
        house(150, 150, 5, 15)};
    Play together(ground, support::lively(Model::kBcreInertial)),
        apart(ground, support::lively(Model::kBcreInertial));
    sim::apply_commands(together.state, commands);
    for (const Command& each : commands) sim::apply_commands(apart.state, {&each, 1});
    EXPECT_EQ(sim::state_hash(together.state), sim::state_hash(apart.state));
    const sim::Things &one = *together.state.things, &other = *apart.state.things;
    EXPECT_TRUE(support::same_bits(together.state.bedrock, apart.state.bedrock));
    for (const auto field : {&sim::Things::built, &sim::Things::built_drag, &sim::Things::drag,
                             &sim::Things::net_depth, &sim::Things::hold})
        EXPECT_TRUE(support::same_bits(one.*field, other.*field));
    EXPECT_EQ(one.wooded, other.wooded);
    EXPECT_EQ(one.loaded.size(), other.loaded.size());
    EXPECT_GT(one.wooded.size(), 0u);
}

TEST(Commands, of_things_visit_a_bounded_number_of_vertices_in_a_tick) {
    const sim::Grid small{161, 161, 5}, large{1025, 1025, 2};
    const auto strokes = [](std::size_t count, double radius) {
        return std::vector<Command>(count, sculpting(CommandKind::kSmooth, 400, 400, radius, 1));
    };
    EXPECT_FALSE(sim::fault_of_visits(small, strokes(sim::kMostCommandsPerTick, 100)));
    EXPECT_FALSE(sim::fault_of_visits(large, strokes(sim::kMostVisits, 1e5)));
    const auto fault = sim::fault_of_visits(large, strokes(sim::kMostVisits + 1, 1e5));
    ASSERT_TRUE(fault);
    EXPECT_NE(fault->find("17860625 vertices"), std::string::npos) << *fault;
    EXPECT_FALSE(sim::fault_of_visits(large, strokes(63, 1e5), sim::kAlwaysVisitsBefore));
    // Far beside the grid there is nothing to visit.
    std::vector<Command> beside = strokes(sim::kMostCommandsPerTick, 1e5);
    for (Command& each : beside) each.x = -2e5;
    EXPECT_FALSE(sim::fault_of_visits(large, beside));

    // Objects take the whole grid, once for all in a row.
    EXPECT_FALSE(sim::fault_of_visits(large, std::vector<Command>(200, house(100, 100, 5))));
    std::vector<Command> mixed;
    for (int i = 0; i < 17; ++i) {
        mixed.push_back(house(100, 100, 5));
        mixed.push_back(sculpting(CommandKind::kSculpt, 100, 100, 1, 1));
    }
    EXPECT_TRUE(sim::fault_of_visits(large, mixed));
    EXPECT_FALSE(sim::fault_of_visits(small, mixed));
}

// A row of 10,000 nets is refused before any is made; the count is what built() makes.
TEST(Things, that_are_too_many_are_refused_before_they_are_made) {
    const Ground ground = level(100, 0.5f, 0);
    const Play play(ground, frictionless(Model::kVoellmy));
    const Command fits = line(CommandKind::kNet, 1, 1, 1, 49);
    EXPECT_FALSE(sim::fault_of_place(play.state, fits));
    Play built(ground, frictionless(Model::kVoellmy));
    sim::apply_commands(built.state, {&fits, 1});
    EXPECT_EQ(built.state.things->list.size(), 96u);
    const Command far = line(CommandKind::kNet, 1, 1, 1, 4900);
    const auto fault = sim::fault_of_place(play.state, far);
    ASSERT_TRUE(fault);
    EXPECT_NE(fault->find("over 2000 objects"), std::string::npos) << *fault;
}

TEST(Direction, is_the_sine_and_cosine_of_a_bearing) {
    for (int degrees = -360; degrees <= 360; degrees += 7) {
        const sim::Direction direction = sim::direction_of(degrees);
        const double angle = degrees * 3.14159265358979323846 / 180;
        EXPECT_NEAR(direction.x, std::sin(angle), 1e-15);
        EXPECT_NEAR(direction.y, std::cos(angle), 1e-15);
    }
}

}  // namespace
