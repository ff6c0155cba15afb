#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "sim/world/quanta.h"
#include "sim/world/things.h"
#include "tests/support/worlds.h"

// What things do to a flow: walls, forest and nets, on slopes and cells of several sizes.

namespace {

using sim::Command;
using sim::CommandKind;
using sim::Model;
using support::Ground;
using support::Play;

// What becomes of 2 m of frictionless flow, 200 m long, that runs along level ground against a wall of earth.
struct Passage {
    double share;    // of the volume that gets over it
    double fastest;  // m/s, of what is at least 5 cm thick
};
Passage passage(double dx, double speed, double wall_m) {
    constexpr double kWallAt = 400, kThick = 50, kEnd = 1400, kLong = 200;
    const int nx = static_cast<int>(kEnd / dx), first = static_cast<int>(std::lround(kWallAt / dx));
    Ground ground({nx, 5, static_cast<float>(dx)});
    ground.set(ground.rolling,
               [&](double x, double) { return x > kWallAt - 20 - kLong && x < kWallAt - 20 ? 2.0 : 0.0; });
    sim::Params params;
    params.model = Model::kVoellmy;
    params.friction = 0;
    params.drag = 1e6f;
    params.borders = {sim::Border::kOpen, sim::Border::kOpen, sim::Border::kWall, sim::Border::kWall};
    Play play(ground, params);
    sim::State& s = play.state;
    sim::Things& things = sim::things_of(s);
    for (int y = 0; y < 5; ++y)
        for (int x = first; x < first + static_cast<int>(kThick / dx); ++x) {
            things.earth(x, y) = static_cast<float>(wall_m);
            sim::set_bedrock(s, x, y);
        }
    double all = 0, over = 0;
    Passage result{};
    for (int x = 0; x < nx; ++x)
        for (int y = 0; y < 5; ++y)
            if (s.rolling(x, y) > 0) s.velocity_x(x, y) = static_cast<float>(speed), all += s.rolling(x, y);
    for (int i = 0; i < 20 * 60; ++i) {
        play.ticks(1);
        for (int x = 0; x < nx; ++x)
            if (s.rolling(x, 2) >= 0.05f)
                result.fastest = std::max(result.fastest, static_cast<double>(std::abs(s.velocity_x(x, 2))));
    }
    for (int x = first; x < nx; ++x)
        for (int y = 0; y < 5; ++y) over += s.rolling(x, y);
    EXPECT_EQ(s.ledger.mass_error(), 0);
    result.share = over / all;
    return result;
}

TEST(Walls, are_closed_or_open_by_the_head_of_the_flow_on_any_grid) {
    // Heads v²/2g are 5.1 m and 20.4 m. docs/things.md has this table.
    struct Row {
        double dx, speed, wall, share, tolerance;
    };
    constexpr Row kRows[] = {
        {12.5, 10, 8, 0, 0},      {12.5, 10, 10, 0, 0}, {12.5, 10, 15, 0, 0},   {12.5, 10, 20, 0, 0},
        {12.5, 10, 40, 0, 0},     {5, 10, 8, 0, 1e-4},  {5, 10, 10, 0, 0},      {5, 10, 15, 0, 0},
        {5, 10, 20, 0, 0},        {5, 10, 40, 0, 0},    {12.5, 20, 8, 1, 0.05}, {12.5, 20, 10, 1, 0.05},
        {12.5, 20, 15, .88, .05}, {12.5, 20, 40, 0, 0}, {5, 20, 8, 1, 0.05},    {5, 20, 10, 1, 0.05},
        {5, 20, 15, 0.88, 0.05},  {5, 20, 20, 0, 0},    {5, 20, 40, 0, 0},      {12.5, 20, 20, 0.34, 0.05},
    };
    for (const Row& row : kRows) {
        const Passage result = passage(row.dx, row.speed, row.wall);
        if (row.tolerance == 0)
            EXPECT_EQ(result.share, 0) << row.dx << " m, " << row.speed << " m/s, " << row.wall << " m";
        else
            EXPECT_NEAR(result.share, row.share, row.tolerance)
                << row.dx << " m, " << row.speed << " m/s, " << row.wall << " m";
        EXPECT_LT(result.fastest, row.speed == 10 ? 12 : 24.5)
            << row.dx << " m, " << row.speed << " m/s, " << row.wall << " m";
    }
}

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

double cubic_metres(const sim::State& s, std::int64_t quanta) {
    return static_cast<double>(quanta) * static_cast<double>(sim::kQuantum) * s.grid.cell_area();
}

// What a blast of 20 m radius on a slope under 1 m of snow-dry sends out of the world, m³. The slope is bare for the
// first 60 m and the last 100 m; between them it has 200 m of forest.
struct Slide {
    double out;
    bool forest_breaks;
};
Slide slide_through_forest(double slope_deg, int stems) {
    constexpr double kCell = 5, kForest = 60, kBare = 260, kEnd = 360, kWide = 400;
    Ground ground({static_cast<int>(kWide / kCell) + 1, static_cast<int>(kEnd / kCell) + 1, kCell});
    ground.set(ground.bedrock, [&](double, double y) { return -std::tan(radians(slope_deg)) * y; });
    ground.set(ground.depth, [](double, double) { return 1; });
    ground.density = 200;
    ground.forest.resize(ground.grid.size());
    for (int y = 0; y < ground.grid.ny; ++y)
        for (int x = 0; x < ground.grid.nx; ++x)
            if (y * kCell > kForest && y * kCell <= kBare)
                ground.forest[ground.at(x, y)] = {static_cast<std::uint16_t>(stems), 0, 30, 22};
    Play play(ground, support::loose_dry_snow());
    Command blast;
    blast.kind = CommandKind::kBlast;
    blast.x = kWide / 2, blast.y = kForest - 20, blast.radius = 20;
    blast.depth = 1;
    play.ticks(1, {&blast, 1});
    play.until_rest(120);
    const sim::Field<sim::Stems>& forest = play.state.things->forest;
    bool breaks = false;
    for (int y = 0; y < forest.ny(); ++y)
        breaks = breaks || std::any_of(forest.row(y), forest.row(y) + forest.nx(),
                                       [](const sim::Stems& at) { return at.lying > 0; });
    return {cubic_metres(play.state, play.state.ledger.out), breaks};
}

TEST(Forest, keeps_most_of_a_small_slide_back) {
    // 7,558, 4,030 and 2,239 m³.
    const Slide bare = slide_through_forest(35, 0), thin = slide_through_forest(35, 200),
                dense = slide_through_forest(35, 400);
    EXPECT_GT(bare.out, 2000);
    EXPECT_LT(thin.out, 2.0 / 3 * bare.out);
    EXPECT_LE(dense.out, 1.0 / 3 * bare.out);
    EXPECT_FALSE(thin.forest_breaks);
    EXPECT_FALSE(dense.forest_breaks);
}

TEST(Forest, breaks_under_a_large_slide_and_keeps_hardly_any_of_it) {
    // 26,412, 26,156 and 25,974 m³.
    const double bare = slide_through_forest(45, 0).out;
    EXPECT_GT(bare, 20'000);
    for (const int stems : {200, 400}) {
        const Slide slide = slide_through_forest(45, stems);
        EXPECT_TRUE(slide.forest_breaks) << stems;
        EXPECT_LT(slide.out, bare) << stems;
        EXPECT_GT(slide.out, 0.95 * bare) << stems;
    }
}

// What starts on a slope of 40° if a trench is dug across it, with or without nets of 3 m above the trench, m³.
double starts_above_a_trench(double cover, double trench, bool has_nets) {
    constexpr int kSquares = 40, kTrench = 20;
    constexpr double kCell = 5;
    Ground ground = support::plane(kSquares, kCell, std::tan(radians(40)), cover);
    ground.density = 200;
    if (has_nets) {
        Command nets;
        nets.kind = CommandKind::kNet;
        nets.y = nets.to_y = (kTrench - 1) * kCell;
        nets.to_x = kSquares * kCell;
        nets.height = 3, nets.strength = 30;
        ground.placed = {nets};
    }
    Play play(ground, support::loose_dry_snow());
    std::vector<Command> digs;
    for (int x = kSquares / 4; x <= 3 * kSquares / 4; ++x) {
        Command dig;
        dig.kind = CommandKind::kDig;
        dig.x = x * kCell, dig.y = kTrench * kCell, dig.radius = 0;
        dig.rate = 10 * trench, dig.duration = 0.1;
        digs.push_back(dig);
    }
    play.ticks(6, digs);
    EXPECT_NEAR(static_cast<double>(play.state.depth(kSquares / 2, kTrench)), cover - trench, 1e-3);
    play.until_rest(60);
    double started = 0;
    for (int y = 0; y <= kSquares; ++y)
        for (int x = 0; x <= kSquares; ++x)
            if (y != kTrench)
                started += std::max(0.0, cover - static_cast<double>(play.state.depth(x, y))) * kCell * kCell;
    return started;
}

TEST(Nets, hold_the_snow_above_a_trench) {
    EXPECT_GT(starts_above_a_trench(3, 3, false), 30'000);  // 63,497 m³
    EXPECT_EQ(starts_above_a_trench(3, 3, true), 0);
    EXPECT_EQ(starts_above_a_trench(3, 1, false), 0);
    EXPECT_EQ(starts_above_a_trench(3, 1, true), 0);
}

TEST(Nets, let_snow_start_that_buries_them) {
    EXPECT_GT(starts_above_a_trench(4, 3, true), 10'000);  // 13,688 m³; without nets 85,418
}

// 2 m of flow that keeps its speed on a slope of 20°, and runs into a house of 25 m by 25 m, 8 m high. Each greatest in
// 14 s: depth at the vertices in the middle before and behind the house, m, and speed across the slope, m/s.
struct Parting {
    double before, behind, sideways;
};
Parting part_around_a_house(double speed, bool has_house) {
    constexpr double kCell = 5, kThick = 2, kSize = 25, kFriction = 0.25;
    constexpr int kMiddleX = 20, kMiddleY = 80;
    constexpr int kBeside = 3;  // vertices from the middle to the first one outside
    const double slope = radians(20), along = speed / std::cos(slope);
    Ground ground({2 * kMiddleX + 1, kMiddleY + 20, kCell});
    ground.set(ground.bedrock, [&](double, double y) { return -std::tan(slope) * y; });
    ground.set(ground.rolling,
               [&](double, double y) { return y > 20 && y < kMiddleY * kCell - 30 ? kThick : 0.0; });
    if (has_house) {
        Command house;
        house.kind = CommandKind::kHouse;
        house.x = kMiddleX * kCell, house.y = kMiddleY * kCell;
        house.length = house.width = kSize, house.height = 8;
        house.strength = 1000;
        ground.placed = {house};
    }
    sim::Params params;
    params.model = Model::kVoellmy;
    params.friction = static_cast<float>(kFriction);
    params.drag = static_cast<float>(
        along * along / (kThick * std::cos(slope) * (std::sin(slope) - kFriction * std::cos(slope))));
    params.borders = {sim::Border::kWall, sim::Border::kWall, sim::Border::kOpen, sim::Border::kOpen};
    Play play(ground, params);
    sim::State& s = play.state;
    for (int y = 0; y < s.grid.ny; ++y)
        for (int x = 0; x < s.grid.nx; ++x)
            if (s.rolling(x, y) > 0) s.velocity_y(x, y) = static_cast<float>(speed);
    Parting greatest{};
    const auto keep = [](double& most, float value) { most = std::max(most, static_cast<double>(value)); };
    for (int tick = 0; tick < 60 * 14; ++tick) {
        play.ticks(1);
        keep(greatest.before, s.rolling(kMiddleX, kMiddleY - kBeside));
        keep(greatest.behind, s.rolling(kMiddleX, kMiddleY + kBeside));
        for (int y = 0; y < s.grid.ny; ++y)
            for (int x = 0; x < s.grid.nx; ++x)
                if (s.rolling(x, y) >= 0.1f) keep(greatest.sideways, std::abs(s.velocity_x(x, y)));
    }
    EXPECT_EQ(s.ledger.mass_error(), 0);
    return greatest;
}

TEST(House, parts_a_flow_whose_head_does_not_reach_its_roof) {
    // The head is 5.1 m. 9.2 m before it, .4 m behind, 5.0 m/s.
    const Parting bare = part_around_a_house(10, false), house = part_around_a_house(10, true);
    EXPECT_NEAR(bare.before, 2, 0.05);
    EXPECT_NEAR(bare.behind, 2, 0.05);
    EXPECT_LT(bare.sideways, 0.01);
    EXPECT_GT(house.before, 7.5);
    EXPECT_LT(house.behind, 1.1);
    EXPECT_GT(house.sideways, 2.7);
}

TEST(House, is_run_over_by_a_flow_whose_head_is_far_above_its_roof) {
    // The head is 14.7 m. 2.4 m before it, 2.0 m behind.
    const Parting house = part_around_a_house(17, true);
    EXPECT_LT(house.before, 3);
    EXPECT_GT(house.behind, 1.5);
}

}  // namespace
