#include "game/app/dam_lines.h"

#include <gtest/gtest.h>

#include "sim/world/ledger.h"
#include "tests/support/worlds.h"

namespace game::test {
namespace {

constexpr double kDamCell = 10;  // m

// Level ground, 800 m across.
class DamLinesOnLevelGround : public testing::Test {
  protected:
    // Two vertices, by 3 and by 1 m, and another by a hand's breadth.
    void raise_a_dam() {
        sim::State& world = play_.state;
        world.things.emplace(world.grid);
        const auto raise = [&](int x, int y, float by) {
            world.things->earth(x, y) = by;
            world.bedrock(x, y) += by;
        };
        raise(20, 20, 3), raise(21, 20, 1), raise(22, 20, 0.125f);
    }

    // As seen from the side: px are metres east, and up from the ground. `x`, `y`: under the cursor.
    DamLines traced(int x, int y) const {
        DamLines lines;
        const sim::State& world = play_.state;
        lines.trace(
            sim::view(world), {{}, 0, 0, x, y, 0},
            [](std::int64_t quanta) {
                return static_cast<double>(quanta) * double{sim::kQuantum} * kDamCell * kDamCell;
            },
            [&](glm::dvec2 at) -> std::optional<glm::dvec2> {
                const auto column = static_cast<int>(at.x / kDamCell),
                           row = static_cast<int>(at.y / kDamCell);
                return glm::dvec2(at.x, static_cast<double>(world.bedrock(column, row)) + world.datum);
            },
            [](glm::dvec3 at) -> std::optional<glm::dvec2> { return glm::dvec2(at.x, at.z); });
        return lines;
    }

  private:
    support::Play play_{support::Ground({81, 41, static_cast<float>(kDamCell)}), support::loose_dry_snow()};
};

TEST_F(DamLinesOnLevelGround, go_up_from_the_ground_that_was_there_and_tell_height_and_volume) {
    raise_a_dam();
    const DamLines lines = traced(18, 19);
    ASSERT_EQ(lines.lines().size(), 2u) << "a hand's breadth is no dam";
    EXPECT_EQ(lines.lines()[0].from, glm::dvec2(200, 0));
    EXPECT_EQ(lines.lines()[0].to, glm::dvec2(200, 3));
    EXPECT_EQ(lines.lines()[1].to, glm::dvec2(210, 1));
    ASSERT_TRUE(lines.note());
    EXPECT_EQ(lines.note()->at, glm::dvec2(200, 3));
    EXPECT_EQ(lines.note()->height, 3);
    EXPECT_NEAR(lines.note()->volume, 412.5, 1e-9) << "all earth counts";
}

TEST_F(DamLinesOnLevelGround, are_of_the_dam_near_the_cursor_alone) {
    raise_a_dam();
    const DamLines lines = traced(23 + DamLines::kReach, 20);
    EXPECT_TRUE(lines.lines().empty());
    EXPECT_FALSE(lines.note());
}

TEST_F(DamLinesOnLevelGround, are_none_in_a_world_without_earth) {
    EXPECT_FALSE(traced(20, 20).note());
}

}  // namespace
}  // namespace game::test
