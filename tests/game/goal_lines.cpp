#include "game/app/goal_lines.h"

#include <algorithm>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace game::test {
namespace {

constexpr sim::Grid kMap{41, 31, 10};  // 400 m by 300 m

// Places are where they are in plan, px for metres.
std::optional<glm::dvec2> in_plan(glm::dvec2 place) {
    return place;
}

double none(const Quantity&) {
    return 0;
}

bool is_zone(const ui::GoalLine& line) {
    return line.around == ui::GoalLine::Around::kZone;
}

Goal with_areas() {
    Goal goal;
    goal.zone = Area{Area::Shape::kBox, {100, 100}, {200, 250}};
    goal.score.push_back({{Measure::kRemoved, Area{Area::Shape::kEllipse, {300, 150}, {50, 30}}}, 1});
    return goal;
}

TEST(GoalLines, run_around_the_zone_and_what_is_counted) {
    GoalLines lines;
    lines.trace(with_areas(), kMap, {}, {}, in_plan, none);
    ASSERT_FALSE(lines.lines().empty());
    double zone = 0, counted = 0;
    for (const ui::GoalLine& line : lines.lines()) {
        (is_zone(line) ? zone : counted) += glm::distance(line.from, line.to);
        for (const glm::dvec2 at : {line.from, line.to}) {
            if (is_zone(line)) {
                const bool on_side = at.x == 100 || at.x == 200, on_end = at.y == 100 || at.y == 250;
                EXPECT_TRUE(on_side || on_end) << at.x << " " << at.y;
            } else {
                EXPECT_NEAR(glm::length((at - glm::dvec2(300, 150)) / glm::dvec2(50, 30)), 1, 1e-9);
            }
        }
    }
    // Half of the way is dashes.
    EXPECT_NEAR(zone, 250, 1);
    EXPECT_NEAR(counted, 255.3 / 2, 2);
}

TEST(GoalLines, end_at_the_border_of_the_map_and_where_the_ground_hides_them) {
    Goal goal;
    goal.zone = Area{Area::Shape::kBox, {-1e9, 100}, {1e9, 1e9}};
    GoalLines lines;
    const auto east_is_hidden = [](glm::dvec2 place) -> std::optional<glm::dvec2> {
        if (place.x > 300) return std::nullopt;
        return place;
    };
    lines.trace(goal, kMap, {}, {}, east_is_hidden, none);
    ASSERT_FALSE(lines.lines().empty());
    for (const ui::GoalLine& line : lines.lines())
        for (const glm::dvec2 at : {line.from, line.to}) {
            EXPECT_TRUE(0 <= at.x && at.x <= 300) << at.x;
            EXPECT_TRUE(100 <= at.y && at.y <= 300) << at.y;
        }
}

TEST(GoalLines, are_traced_once_per_view_and_name_no_place_twice) {
    Goal goal = with_areas();
    goal.zone = goal.score.front().quantity.area;
    int looked = 0;
    const auto count = [&](glm::dvec2 place) {
        ++looked;
        return std::optional(place);
    };
    GoalLines lines;
    lines.trace(goal, kMap, {}, {}, count, none);
    const int once = looked;
    EXPECT_TRUE(std::ranges::none_of(lines.lines(), is_zone));
    lines.trace(goal, kMap, {}, {}, count, none);
    EXPECT_EQ(looked, once);
    lines.trace(goal, kMap, {{}, 0, 0, 1}, {}, count, none);
    EXPECT_EQ(looked, 2 * once);
}

TEST(GoalLines, tell_what_each_area_came_to_and_ask_again_when_the_surface_has_changed) {
    Goal goal = with_areas();
    const Area fan{Area::Shape::kBox, {50, -1e9}, {150, 100}};
    const Quantity deposit{Measure::kDeposit, fan};
    goal.needs.push_back({deposit, 2000, {}});
    goal.score.push_back({deposit, 1});
    int asked = 0;
    const auto amount = [&](const Quantity& quantity) {
        ++asked;
        return quantity == deposit ? 2000. : 7.;
    };
    GoalLines lines;
    const auto trace = [&](int width, std::int64_t ground) {
        lines.trace(goal, kMap, {{}, width, 0, ground}, {}, in_plan, amount);
    };
    trace(0, 0);
    ASSERT_EQ(lines.counts().size(), 2u) << "a need and a score of the same are told once";
    EXPECT_EQ(lines.counts()[0].amount, 2000);
    EXPECT_FALSE(lines.counts()[0].is_share);
    EXPECT_EQ(lines.counts()[0].at, glm::dvec2(100, 90)) << "on the map";
    EXPECT_EQ(lines.counts()[1].amount, 7);
    EXPECT_TRUE(lines.counts()[1].is_share);
    EXPECT_EQ(lines.counts()[1].at, glm::dvec2(300, 174));
    EXPECT_EQ(asked, 2);
    trace(1, 0);
    EXPECT_EQ(asked, 2) << "from elsewhere it is as much";
    trace(1, 1);
    EXPECT_EQ(asked, 4);
}

TEST(GoalLines, run_around_what_is_going_to_happen_and_count_the_seconds_until_then) {
    Goal goal;
    sim::Command blast;
    blast.kind = sim::CommandKind::kBlast;
    blast.x = 200, blast.y = 120, blast.radius = 40, blast.depth = 1;
    goal.events = {{60, blast}, {600, blast}};
    GoalLines lines;
    const auto around = [&](std::int64_t tick) {
        lines = {};
        lines.trace(goal, kMap, {}, {tick, 0.5}, in_plan, none);
        for (const ui::GoalLine& line : lines.lines()) {
            EXPECT_EQ(line.around, ui::GoalLine::Around::kEvent);
            EXPECT_NEAR(glm::distance(line.from, glm::dvec2(200, 120)), 40, 1e-9);
        }
        return lines.events();
    };
    const auto both = around(20), one = around(61), past = around(601);
    ASSERT_EQ(both.size(), 2u);
    EXPECT_EQ(both[0].at, glm::dvec2(200, 120));
    EXPECT_EQ(both[0].in_s, 20);
    EXPECT_EQ(both[1].in_s, 290);
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0].in_s, 269.5);
    EXPECT_TRUE(past.empty());
    EXPECT_TRUE(lines.lines().empty());
}

}  // namespace
}  // namespace game::test
