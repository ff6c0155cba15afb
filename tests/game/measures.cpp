#include "game/analysis/measures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "game/recording/command_source.h"
#include "game/scene/scene.h"
#include "game/session/session.h"

namespace game::test {
namespace {

// 11×9 vertices 10 m apart that rise 5 m with each row to the north.
struct Hill {
    Scenario scenario;

    Hill() {
        scenario.grid = {11, 9, 10.f};
        scenario.depth.assign(scenario.grid.size(), 1.f);
        scenario.rolling.assign(scenario.grid.size(), 0.f);
        scenario.has_data.assign(scenario.grid.size(), 1);
        for (int y = 0; y < 9; ++y)
            scenario.bedrock.insert(scenario.bedrock.end(), 11, 5.f * static_cast<float>(y));
    }
    std::size_t at(int x, int y) const { return static_cast<std::size_t>(y * scenario.grid.nx + x); }
    std::vector<std::uint8_t> flags(std::initializer_list<std::pair<int, int>> places) const {
        std::vector<std::uint8_t> flags(scenario.grid.size());
        for (const auto& [x, y] : places) flags[at(x, y)] = 1;
        return flags;
    }
    // Before a session starts, its peaks are its release.
    Session session() const { return Session::begin(scenario, sim::StepOptions{}, std::nullopt).value(); }
};

TEST(Measures, match_manual_calculation) {
    Hill hill;
    hill.scenario.rolling[hill.at(5, 8)] = 1.f;
    hill.scenario.rolling[hill.at(5, 6)] = 2.5f;
    hill.scenario.rolling[hill.at(2, 2)] = 0.25f;
    hill.scenario.rolling[hill.at(9, 0)] = 0.0625f;  // farther, but too thin to count
    const Session session = hill.session();
    const Measures m = measure(hill.scenario, session, hill.flags({{4, 7}, {5, 8}, {3, 1}}),
                               {hill.flags({{5, 8}, {5, 6}, {1, 1}}), {}});
    EXPECT_DOUBLE_EQ(m.extent_area, 3 * 100.0);
    EXPECT_DOUBLE_EQ(m.peak_depth, 2.5);
    EXPECT_DOUBLE_EQ(m.top.x, 50);
    EXPECT_DOUBLE_EQ(m.top.y, 80);
    EXPECT_DOUBLE_EQ(m.toe.x, 20);
    EXPECT_DOUBLE_EQ(m.toe.y, 20);
    EXPECT_DOUBLE_EQ(m.run_out, std::sqrt(30.0 * 30 + 60.0 * 60));
    EXPECT_DOUBLE_EQ(m.fall, 30);
    EXPECT_NEAR(m.reach_deg, 24.0948425521, 1e-9);  // atan(30 / 67.08)
    ASSERT_TRUE(m.overlap);
    EXPECT_DOUBLE_EQ(*m.overlap, 2.0 / 4);
    EXPECT_DOUBLE_EQ(m.eroded, 0);
    EXPECT_DOUBLE_EQ(m.deposited, 0);
    EXPECT_NEAR(m.peak_thickness, 2.5 / std::sqrt(1 + 0.5 * 0.5), 1e-6) << "5 m on 10 m";
}

// A slab on a plane of 45° under voellmy, whose velocity in plan goes straight down the plane.
TEST(Measures,
     of_a_plane_of_45_degrees_have_a_speed_along_the_slope_of_the_square_root_of_2_times_that_in_plan) {
    Hill hill;
    hill.scenario.params.model = sim::Model::kVoellmy;
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 11; ++x) hill.scenario.bedrock[hill.at(x, y)] = 10.f * static_cast<float>(y);
    hill.scenario.rolling.assign(hill.scenario.grid.size(), 1.f);
    Session session = hill.session();
    for (int tick = 0; tick < 30; ++tick) ASSERT_TRUE(session.advance({}));
    const std::size_t middle = hill.at(5, 4);
    const float plan = session.peaks().speed_plan[middle], slope = session.peaks().speed_slope[middle];
    EXPECT_GT(plan, 1);
    EXPECT_FLOAT_EQ(slope, std::sqrt(2.f) * plan);
    const Measures m = measure(hill.scenario, session, hill.flags({}), {});
    EXPECT_GE(m.peak_speed_plan, plan);
    EXPECT_GE(m.peak_speed_slope, slope);
    EXPECT_GT(m.peak_speed_slope, m.peak_speed_plan);
    EXPECT_FALSE(m.peak_pressure) << "the density is unknown";
}

TEST(Measures, of_pressure_are_density_times_the_square_of_the_speed_along_the_slope) {
    Hill hill;
    hill.scenario.params.model = sim::Model::kVoellmy;
    hill.scenario.params.friction = 0.1f;
    hill.scenario.density = 250;
    hill.scenario.rolling.assign(hill.scenario.grid.size(), 1.f);
    Session session = hill.session();
    for (int tick = 0; tick < 30; ++tick) ASSERT_TRUE(session.advance({}));
    const Measures m = measure(hill.scenario, session, hill.flags({}), {});
    ASSERT_TRUE(m.peak_pressure);
    EXPECT_GT(*m.peak_pressure, 0.1);
    EXPECT_NEAR(*m.peak_pressure, 250 * m.peak_speed_slope * m.peak_speed_slope / 1000,
                1e-6 * *m.peak_pressure);
}

// Tiles sleep, wake and are poured on, and the world goes back in time: no vertex is missed.
TEST(Peaks, found_by_tiles_are_those_of_every_vertex) {
    const Scene scene = load_scene("landslide", {}).value();
    Session session =
        Session::begin(scene.scenario, {.tile_width = 32, .tile_height = 8}, std::nullopt).value();
    const sim::Grid& grid = scene.scenario.grid;
    std::vector<float> deepest(grid.size()), fastest(grid.size());
    std::vector<std::uint32_t> arrival(grid.size(), Peaks::kNever);
    const auto see = [&] {
        std::size_t active = 0, i = 0;
        for (int y = 0; y < grid.ny; ++y)
            for (int x = 0; x < grid.nx; ++x, ++i) {
                const sim::State& now = session.state();
                const float u = now.velocity_x(x, y), v = now.velocity_y(x, y), r = now.rolling(x, y);
                active += r > 0;
                deepest[i] = std::max(deepest[i], r);
                if (r >= Peaks::kVisible)
                    arrival[i] = std::min(arrival[i], static_cast<std::uint32_t>(now.tick));
                if (r >= Peaks::kVisible) fastest[i] = std::max(fastest[i], std::sqrt(u * u + v * v));
            }
        ASSERT_EQ(session.active_cells(), active) << "tick " << session.state().tick;
        ASSERT_EQ(session.peaks().depth, deepest) << "tick " << session.state().tick;
        ASSERT_EQ(session.peaks().speed_plan, fastest) << "tick " << session.state().tick;
        ASSERT_EQ(session.peaks().arrival, arrival) << "tick " << session.state().tick;
    };
    sim::Command pour;
    pour.kind = sim::CommandKind::kPour;
    pour.x = 12, pour.y = 150, pour.radius = 6, pour.rate = 2, pour.duration = 0.5;
    std::optional<Session::Checkpoint> then;
    std::vector<float> deepest_then, fastest_then;
    std::vector<std::uint32_t> arrival_then;
    see();
    for (int tick = 0; tick < 240; ++tick) {
        if (tick == 60) {
            then = session.moment();
            deepest_then = deepest, fastest_then = fastest, arrival_then = arrival;
        }
        if (tick == 180) {
            ASSERT_TRUE(session.rewind(*then));
            deepest = deepest_then, fastest = fastest_then, arrival = arrival_then;
            see();
        }
        std::vector<sim::Command> due;
        if (tick % 40 == 20) due.push_back(pour);
        for (const TimedCommand& each : commands_at(scene.commands, session.state().tick))
            due.push_back(each.command);
        ASSERT_TRUE(session.advance(due));
        see();
        pour.x += 15;
    }
    EXPECT_GT(std::ranges::max(fastest), 1) << "nothing moved";
}

TEST(Measures, tell_of_a_release_and_of_a_flow_that_are_nowhere_four_cells_wide) {
    Hill hill;
    std::vector<std::uint8_t> released(hill.scenario.grid.size());
    const auto lay = [&](int x0, int x1, int y0, int y1, float depth) {
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x)
                hill.scenario.rolling[hill.at(x, y)] = depth, released[hill.at(x, y)] = 1;
    };
    const auto measured = [&] { return measure(hill.scenario, hill.session(), released, {}); };
    EXPECT_FALSE(measured().narrow_release) << "nothing is not narrow";
    EXPECT_FALSE(measured().narrow_flow);
    lay(1, 9, 5, 7, 2);  // 9 by 3
    EXPECT_TRUE(measured().narrow_release);
    EXPECT_TRUE(measured().narrow_flow);
    lay(3, 6, 4, 4, 1);  // and 4 by 4, half as deep
    EXPECT_FALSE(measured().narrow_release);
    EXPECT_FALSE(measured().narrow_flow);
    lay(3, 6, 4, 4, 0.875f);
    EXPECT_TRUE(measured().narrow_flow);
    lay(0, 3, 0, 3, 1.5f);  // wide and deep, but not where it is deepest
    EXPECT_TRUE(measured().narrow_flow);
}

TEST(Densities, are_known_only_if_every_material_has_one_and_mix_by_volume) {
    Scenario scenario;
    EXPECT_FALSE(densities_of(scenario));
    scenario.density = 200;
    EXPECT_EQ(densities_of(scenario).value().of(0), 200);
    EXPECT_EQ(densities_of(scenario).value().of(1), 200);
    scenario.lower.emplace();
    EXPECT_FALSE(densities_of(scenario));
    scenario.lower->density = 1800;
    EXPECT_EQ(densities_of(scenario).value().of(0.25), 600);
    EXPECT_EQ(impact_pressure(200, 10), 20);  // kPa
}

TEST(Measures, without_release_or_reference_have_no_line_and_no_overlap) {
    Hill hill;
    hill.scenario.rolling[hill.at(5, 6)] = 1.f;
    const Session session = hill.session();
    const Measures m = measure(hill.scenario, session, hill.flags({}), {});
    EXPECT_DOUBLE_EQ(m.run_out, 0);
    EXPECT_DOUBLE_EQ(m.reach_deg, 0);
    EXPECT_FALSE(m.overlap);
    EXPECT_DOUBLE_EQ(m.extent_area, 100);
    EXPECT_FALSE(measure(Hill().scenario, Hill().session(), hill.flags({}), {hill.flags({}), {}}).overlap)
        << "nothing over nothing";
}

// Wetted or undercut soil lets go by itself.
TEST(Measures, of_what_nobody_released_have_a_line_from_the_top_of_its_extent) {
    Hill hill;
    for (const auto& [x, y] : {std::pair(5, 8), std::pair(5, 6), std::pair(2, 2)})
        hill.scenario.rolling[hill.at(x, y)] = 1.f;
    const Measures m = measure(hill.scenario, hill.session(), hill.flags({}), {});
    EXPECT_DOUBLE_EQ(m.top.y, 80);
    EXPECT_DOUBLE_EQ(m.toe.y, 20);
    EXPECT_DOUBLE_EQ(m.run_out, std::sqrt(30.0 * 30 + 60.0 * 60));
}

TEST(Measures, count_erosion_and_deposition_of_the_standing_layer) {
    const Hill hill;
    Session session = hill.session();
    sim::Command dig, pour;
    dig.kind = sim::CommandKind::kDig;
    dig.x = dig.y = 30;
    dig.radius = 0;
    dig.rate = 15;  // m/s for a 60th of a second: 0.25 m
    pour.x = pour.y = 60;
    pour.radius = 0;
    pour.rate = 3000;  // m³/s: 50 m³, on one vertex of 100 m²
    pour.layer = sim::Layer::kStanding;
    const std::vector<sim::Command> both{dig, pour};
    ASSERT_TRUE(session.advance(both));
    const Measures m = measure(hill.scenario, session, hill.flags({}), {});
    EXPECT_NEAR(m.eroded, 25, 1e-3);
    EXPECT_NEAR(m.deposited, 50, 1e-3);
}

TEST(Measures, compare_a_change_of_the_surface_with_an_observed_one) {
    const Hill hill;
    Session session = hill.session();
    sim::Command dig, pour;
    dig.kind = sim::CommandKind::kDig;
    dig.x = 50, dig.y = 70;
    dig.radius = 0;
    dig.rate = 30;  // 0.5 m
    pour.x = 50, pour.y = 20;
    pour.radius = 0;
    pour.rate = 3000;  // 0.5 m
    pour.layer = sim::Layer::kStanding;
    const std::vector<sim::Command> both{dig, pour};
    ASSERT_TRUE(session.advance(both));
    terrains::Reference observed;
    observed.change.assign(hill.scenario.grid.size(), 0.f);
    observed.change[hill.at(5, 7)] = -1;
    observed.change[hill.at(5, 4)] = 1;
    observed.change[hill.at(5, 3)] = 0.25f;  // too little to count in the overlap
    const Measures m = measure(hill.scenario, session, hill.flags({}), observed);
    ASSERT_TRUE(m.changes && m.overlap);
    EXPECT_DOUBLE_EQ(*m.overlap, 1. / 3);
    EXPECT_NEAR(m.changes->here.carried, 50, 1e-6);
    EXPECT_NEAR(m.changes->here.raised, 50, 1e-3);
    EXPECT_NEAR(m.changes->observed.carried, 32, 1e-6);  // from 70 m to (4 × 40 + 30) / 5 m
    EXPECT_NEAR(m.changes->observed.raised, 125, 1e-3);
    EXPECT_NEAR(m.changes->apart, 18, 1e-6);
}

TEST(ReleaseArea, is_the_release_and_the_area_of_pours_and_blasts) {
    Hill hill;
    hill.scenario.rolling[hill.at(1, 1)] = 0.5f;
    sim::Command pour, blast, dig;
    pour.x = 50;
    pour.y = 40;
    pour.radius = 10;
    blast = pour;
    blast.kind = sim::CommandKind::kBlast;
    blast.x = 90;
    blast.radius = 9;
    dig.kind = sim::CommandKind::kDig;
    dig.x = 20;
    dig.y = 70;
    // Commands that remove, deposit or set a parameter release nothing.
    sim::Command settle, set;
    settle.kind = sim::CommandKind::kSettle;
    settle.x = settle.y = 70;
    set.kind = sim::CommandKind::kSet;
    const std::vector<TimedCommand> commands{{0, pour}, {5, blast}, {6, dig}, {7, settle}, {8, set}};
    EXPECT_EQ(release_area(hill.scenario, commands),
              hill.flags({{1, 1}, {5, 4}, {4, 4}, {6, 4}, {5, 3}, {5, 5}, {9, 4}}));
}

TEST(ReleaseArea, of_a_command_that_chooses_slopes_is_where_it_acts) {
    const Hill hill;  // of 26.6 degrees
    sim::Command pour;
    pour.x = 50, pour.y = 40, pour.radius = 10;
    pour.least_slope = 20, pour.most_slope = 30;
    EXPECT_EQ(release_area(hill.scenario, std::vector<TimedCommand>{{0, pour}}),
              hill.flags({{5, 4}, {4, 4}, {6, 4}, {5, 3}, {5, 5}}));
    pour.least_slope = 30, pour.most_slope = 40;
    EXPECT_EQ(release_area(hill.scenario, std::vector<TimedCommand>{{0, pour}}), hill.flags({}));
}

TEST(ReleaseArea, of_a_disc_smaller_than_a_cell_is_its_vertex) {
    const Hill hill;
    for (const auto& [x, y] : {std::pair(44.9, 44.9), std::pair(36.0, 44.0), std::pair(40.0, 40.0)})
        for (const double radius : {0.0, 3.0, 9.0}) {
            sim::Command pour;
            pour.x = x;
            pour.y = y;
            pour.radius = radius;
            pour.rate = 6000;
            pour.layer = sim::Layer::kStanding;
            const std::vector<TimedCommand> commands{{0, pour}};
            EXPECT_EQ(release_area(hill.scenario, commands), hill.flags({{4, 4}}))
                << x << " " << y << " " << radius;

            Session session = hill.session();
            ASSERT_TRUE(session.advance(std::vector{pour}));
            EXPECT_GT(session.state().depth(4, 4), 1.9f) << "the simulation poured elsewhere";
        }
}

}  // namespace
}  // namespace game::test
