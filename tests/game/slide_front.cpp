#include "game/controls/slide_front.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "game/scene/scene.h"
#include "game/session/session.h"
#include "tests/game/camera_hands.h"

namespace game::test {
namespace {

TEST(SlideFront, is_nowhere_while_nothing_moves_fast) {
    sim::State state = level();
    SlideFront front;
    front.see(sim::view(state));
    EXPECT_FALSE(front.front());
    state.rolling(30, 30) = 1, state.velocity_x(30, 30) = 1.5f;
    front.see(sim::view(state));
    EXPECT_FALSE(front.front());
}

TEST(SlideFront, stays_with_one_of_two_slides_while_that_moves) {
    sim::State state = level();
    const auto put = [&](int x, int y, float depth, float speed) {
        state.rolling(x, y) = depth, state.velocity_y(x, y) = -speed;
    };
    put(10, 40, 2, 20), put(50, 40, 1, 20);
    SlideFront front;
    front.see(sim::view(state));
    ASSERT_TRUE(front.front());
    EXPECT_EQ(glm::dvec2(front.front()->at), glm::dvec2(100, 400));
    EXPECT_EQ(front.front()->heading, glm::dvec2(0, -1));
    for (int y = 39; y > 20; --y) {
        put(10, y + 1, 0, 0), put(50, y + 1, 0, 0);
        put(10, y, 1, 10), put(50, y, 3, 30);  // the other is larger now
        front.see(sim::view(state));
        ASSERT_TRUE(front.front());
        EXPECT_EQ(glm::dvec2(front.front()->at), glm::dvec2(100, 10 * y));
    }
    put(10, 21, 0, 0);
    front.see(sim::view(state));
    ASSERT_TRUE(front.front());
    EXPECT_EQ(glm::dvec2(front.front()->at), glm::dvec2(500, 210));
}

TEST(SlideFront, runs_down_the_valley_with_a_real_slide) {
    Overrides overrides;
    overrides.squares = 80;
    const Scene scene = load_scene("winter-avalanche", overrides).value();
    auto session = Session::begin(scene.scenario, sim::StepOptions{}, std::nullopt).value();
    SlideFront front;
    std::size_t next = 0;
    double fastest = 0, highest = 0, lowest = 1e9;
    std::optional<glm::dvec3> before;
    while (session.state().tick < 2700) {
        std::vector<sim::Command> due;
        for (; next < scene.commands.size() && scene.commands[next].tick == session.state().tick; ++next)
            due.push_back(scene.commands[next].command);
        ASSERT_TRUE(session.advance(due));
        if (session.state().tick % 6 != 0) continue;  // ten frames a second
        front.see(session.view());
        if (!front.front()) continue;
        const glm::dvec3 at = front.front()->at;
        if (before) fastest = std::max(fastest, glm::distance(at, *before) * 10);
        before = at;
        highest = std::max(highest, at.z), lowest = std::min(lowest, at.z);
    }
    EXPECT_GT(highest - lowest, 400);
    EXPECT_LT(fastest, 150) << "m/s: it jumps";
}

}  // namespace
}  // namespace game::test
