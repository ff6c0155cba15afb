#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

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

}  // namespace
