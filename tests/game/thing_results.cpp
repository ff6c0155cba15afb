// What a summary tells of things.
#include "game/analysis/thing_results.h"

#include <gtest/gtest.h>

#include "game/analysis/headless.h"
#include "game/analysis/summary.h"
#include "game/analysis/thing_report.h"
#include "game/scene/standing.h"

namespace game::test {
namespace {

// 21×21 vertices 5 m apart, level, under 1 m of material.
Scenario plain() {
    Scenario scenario;
    scenario.grid = {21, 21, 5.f};
    scenario.density = 200;
    scenario.bedrock.assign(scenario.grid.size(), 0.f);
    scenario.depth.assign(scenario.grid.size(), 1.f);
    scenario.rolling.assign(scenario.grid.size(), 0.f);
    scenario.has_data.assign(scenario.grid.size(), 1);
    return scenario;
}

sim::Command line(sim::CommandKind kind, double x, double to_x, double y) {
    sim::Command command;
    command.kind = kind;
    command.x = x, command.to_x = to_x;
    command.y = command.to_y = y;
    return command;
}

sim::Command house_at(double x, double y) {
    sim::Command house;
    house.kind = sim::CommandKind::kHouse;
    house.x = x, house.y = y;
    house.length = 8, house.width = 6, house.height = 5, house.strength = 10;
    return house;
}

Session begun(const Scenario& scenario) {
    return Session::begin(scenario, sim::StepOptions{}, std::nullopt).value();
}

Json summary_of(const Scenario& scenario, const Session& session) {
    const Measures measures;
    return to_json(Summary{scenario, session, measures, nullptr, std::nullopt, std::nullopt});
}

TEST(ThingResults, are_left_out_of_a_world_without_things) {
    const Scenario scenario = plain();
    const Session session = begun(scenario);
    EXPECT_FALSE(summary_of(scenario, session).contains("things"));
}

TEST(ThingResults, name_each_object_with_its_load_and_state) {
    Scenario scenario = plain();
    scenario.standing.placed = {house_at(30, 40), line(sim::CommandKind::kNet, 50, 62, 20)};
    scenario.standing.placed[1].height = 3, scenario.standing.placed[1].strength = 30;
    const Json things = summary_of(scenario, begun(scenario))["things"];
    ASSERT_EQ(things["objects"].size(), 4u);  // a net has a piece for each cell
    const Json house = things["objects"][0];
    EXPECT_EQ(house["kind"], "house");
    EXPECT_EQ(house["x_m"], 30);
    EXPECT_EQ(house["y_m"], 40);
    EXPECT_EQ(house["strength_kpa"], 10);
    EXPECT_EQ(house["load_kpa"], 0);
    EXPECT_EQ(house["buried_m"], 0);
    EXPECT_EQ(house["state"], "intact");
    EXPECT_EQ(things["objects"][2]["kind"], "net");
    EXPECT_EQ(things["objects"][2]["x_m"], 56);
}

TEST(ThingResults, measure_forest_by_the_share_that_stands) {
    Scenario scenario = plain();
    scenario.standing.forest.resize(scenario.grid.size());
    for (std::size_t i = 100; i < 108; ++i) scenario.standing.forest[i] = {300, 100, 30, 22};
    const ThingResults results = thing_results(begun(scenario));
    EXPECT_NEAR(results.forest_intact_ha, 8 * 25e-4 * 0.75, 1e-12);
    EXPECT_NEAR(results.forest_broken_ha, 8 * 25e-4 * 0.25, 1e-12);
}

TEST(ThingResults, measure_the_road_that_is_blocked_and_the_earth_in_use) {
    Scenario scenario = plain();
    scenario.standing.earth_budget = 1000;
    scenario.standing.placed = {line(sim::CommandKind::kRoad, 10, 90, 50)};
    scenario.standing.placed[0].width = 6;
    sim::Command sculpt;
    sculpt.kind = sim::CommandKind::kSculpt;
    sculpt.x = sculpt.y = 20, sculpt.radius = 0, sculpt.rise = 2;
    scenario.standing.placed.push_back(sculpt);
    Session session = begun(scenario);
    const ThingResults before = thing_results(session);
    EXPECT_DOUBLE_EQ(before.road, 80);
    EXPECT_DOUBLE_EQ(before.road_blocked, 0);
    EXPECT_DOUBLE_EQ(before.earth_used, 2 * 25);
    sim::Command
        pour;  // 1 m on one vertex of the road; between vertices it falls to 0, and to .3 m within 3.5 m
    pour.x = pour.y = 50;
    pour.radius = 0;
    pour.rate = 25 * 60;
    pour.layer = sim::Layer::kStanding;
    ASSERT_TRUE(session.advance(std::vector<sim::Command>{pour}));
    EXPECT_NEAR(thing_results(session).road_blocked, 7, 1.3);
    const Json things = summary_of(scenario, session)["things"];
    EXPECT_EQ(things["earth"]["used_m3"], 50);
    EXPECT_EQ(things["earth"]["budget_m3"], 1000);
    EXPECT_EQ(things["road"]["length_m"], 80);
    EXPECT_EQ(things["objects"][0]["state"], "blocked");
    const std::string text = things_to_text(scenario, session);
    EXPECT_NE(text.find("earth: 50.0 of 1000.0 m3 used"), std::string::npos) << text;
    EXPECT_NE(text.find("road: 80 m, of which"), std::string::npos) << text;
}

}  // namespace
}  // namespace game::test
