#include "game/app/slide_map.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace game::test {
namespace {

// A slope of so many squares of 2 m down to the south, on which two metres at a place start to flow.
Scenario slope_of(int east, int north) {
    Scenario scenario;
    scenario.grid = {east + 1, north + 1, 2};
    for (int y = 0; y <= north; ++y)
        for (int x = 0; x <= east; ++x) scenario.bedrock.push_back(static_cast<float>(y));
    scenario.depth.assign(scenario.grid.size(), 0);
    scenario.rolling.assign(scenario.grid.size(), 0);
    scenario.has_data.assign(scenario.grid.size(), 1);
    return scenario;
}

std::shared_ptr<const ui::SlideMap> map_after(const Scenario& scenario, int ticks,
                                              const std::vector<TimedCommand>& by_hand) {
    auto session = Session::begin(scenario, {}, std::nullopt).value();
    for (int tick = 0; tick < ticks; ++tick) {
        std::vector<sim::Command> now;
        for (const TimedCommand& each : commands_at(by_hand, tick)) now.push_back(each.command);
        EXPECT_TRUE(session.advance(now));
    }
    return map_of_slide(scenario, session, by_hand);
}

TimedCommand pour_at(std::int64_t tick, double x, double y) {
    TimedCommand pour{tick, {}};
    pour.command.kind = sim::CommandKind::kPour;
    pour.command.x = x, pour.command.y = y, pour.command.radius = 6, pour.command.rate = 6000;
    return pour;
}

// Blue is more than red in what flowed, and no relief is that blue.
bool flowed_at(const ui::SlideMap& map, glm::dvec2 place) {
    const glm::dvec2 share = (place - map.south_west) / (map.north_east - map.south_west);
    const int x = std::clamp(static_cast<int>(share.x * map.width), 0, map.width - 1),
              y = std::clamp(static_cast<int>((1 - share.y) * map.height), 0, map.height - 1);
    const std::uint8_t* const texel = &map.texels[static_cast<std::size_t>(3 * (y * map.width + x))];
    return texel[2] > texel[0] + 30;
}

TEST(SlideMap, shows_what_flowed_where_it_flowed_and_what_was_done) {
    const std::vector<TimedCommand> pours{pour_at(0, 80, 140), pour_at(1, 81, 140), pour_at(2, 40, 60),
                                          pour_at(3, 40, 61)};
    const auto map = map_after(slope_of(80, 80), 120, pours);
    ASSERT_TRUE(map);
    EXPECT_EQ(map->texels.size(), static_cast<std::size_t>(3 * map->width * map->height));
    for (const glm::dvec2 place : {glm::dvec2(80, 138), glm::dvec2(40, 58)})
        EXPECT_TRUE(flowed_at(*map, place));
    for (const glm::dvec2 place : {glm::dvec2(130, 100), glm::dvec2(80, 60), glm::dvec2(40, 120)})
        EXPECT_FALSE(flowed_at(*map, place));
    ASSERT_EQ(map->marks.size(), 2u) << "two are at the same place each";
    EXPECT_EQ(map->marks[1].at, glm::dvec2(40, 60));
}

TEST(SlideMap, has_no_map_of_nothing) {
    EXPECT_FALSE(map_after(slope_of(20, 20), 5, {}));
}

TEST(SlideMap, stays_small_and_on_the_grid_whatever_the_grids_shape) {
    for (const auto& [east, north] : {std::pair(300, 8), std::pair(8, 300), std::pair(8, 8)}) {
        const double x = east, y = north;  // the middle, m
        const auto map =
            map_after(slope_of(east, north), 60, {pour_at(0, x, y), pour_at(30, 0.2 * x, 0.2 * y)});
        ASSERT_TRUE(map);
        EXPECT_LE(map->width, 2 * map->height);
        EXPECT_LE(map->height, 2 * map->width);
        EXPECT_LE(map->texels.size(), 1'000'000u);
        for (int i = 0; i < 2; ++i) {
            EXPECT_GE(map->south_west[i], 0);
            EXPECT_LE(map->north_east[i], 2 * (i == 0 ? east : north) + 1e-3);
        }
    }
}

}  // namespace
}  // namespace game::test
