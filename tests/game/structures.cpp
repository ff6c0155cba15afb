#include "game/scene/structures.h"

#include <gtest/gtest.h>

#include "tests/support/worlds.h"

// Where structures may stand, and what a flow does to them.
namespace game {
namespace {

using render::Structure;
using render::StructureKind;
using render::StructureState;

constexpr int kSide = 41;  // vertices
constexpr float kCell = 5;

class Village : public testing::Test {
  protected:
    StructureState state_after(StructureKind kind, float pressure, float depth, float rise = 0) {
        render::Structures structures;
        structures.all.push_back({kind, {100, 100}, 30});
        StructureWatch watch(structures, sim::view(level(0)));
        const std::vector<float> pressures(grid_.size(), pressure), depths(grid_.size(), depth);
        watch.watch(sim::view(level(rise)), pressures, depths);
        return watch.structures().all[0].state;
    }
    // A world of level ground under a standing layer.
    sim::State level(double depth) const {
        return sim::make_state(support::plane(kSide - 1, kCell, 0, depth).world(), {});
    }
    std::optional<std::string> fault(const render::Structures& structures) const {
        return fault_of(structures, grid_, data_);
    }
    static render::Structures hut_at(glm::dvec2 at) {
        render::Structures structures;
        structures.all.push_back({StructureKind::kHut, at});
        return structures;
    }

    sim::Grid grid_{kSide, kSide, kCell};
    std::vector<std::uint8_t> data_ = std::vector<std::uint8_t>(grid_.size(), 1);
};

TEST_F(Village, is_damaged_from_half_of_its_strength_and_destroyed_from_all_of_it) {
    EXPECT_EQ(state_after(StructureKind::kHut, 2.4f, 1), StructureState::kIntact);
    EXPECT_EQ(state_after(StructureKind::kHut, 2.6f, 2), StructureState::kDamaged);
    EXPECT_EQ(state_after(StructureKind::kHut, 4.9f, 1), StructureState::kDamaged);
    EXPECT_EQ(state_after(StructureKind::kHut, 5.1f, 1), StructureState::kDestroyed);
    EXPECT_EQ(state_after(StructureKind::kStation, 5.1f, 1), StructureState::kDamaged);
    EXPECT_EQ(state_after(StructureKind::kPylon, 99, 1), StructureState::kDamaged);
    EXPECT_EQ(state_after(StructureKind::kPylon, 101, 1), StructureState::kDestroyed);
}

TEST_F(Village, bears_more_from_a_shallow_flow) {
    EXPECT_EQ(state_after(StructureKind::kHut, 9.9f, 0.5f), StructureState::kDamaged);
    EXPECT_EQ(state_after(StructureKind::kHut, 10.1f, 0.5f), StructureState::kDestroyed);
}

TEST_F(Village, that_is_only_buried_still_stands) {
    const auto height = static_cast<float>(render::kHutHeight);
    EXPECT_EQ(state_after(StructureKind::kHut, 1, 1, height - 0.01f), StructureState::kIntact);
    EXPECT_EQ(state_after(StructureKind::kHut, 1, 1, height), StructureState::kBuried);
    EXPECT_EQ(state_after(StructureKind::kHut, 6, 1, height), StructureState::kDestroyed);
}

TEST_F(Village, is_hit_where_any_corner_of_it_stands_in_the_flow) {
    const sim::State state = level(0);
    std::vector<float> pressure(grid_.size());
    const std::vector<float> depth(grid_.size(), 1);
    for (int y = 0; y < kSide; ++y)  // a flow that passes in the west
        for (int x = 0; x <= 19; ++x) pressure[static_cast<std::size_t>(y * kSide + x)] = 50;
    StructureWatch watch(hut_at({100, 100}), sim::view(state));
    watch.watch(sim::view(state), pressure, depth);
    EXPECT_EQ(watch.structures().all[0].state, StructureState::kDestroyed)
        << "its side is 4.5 m toward the flow";
    watch.watch(sim::view(state), {}, depth);
    EXPECT_EQ(watch.structures().all[0].state, StructureState::kIntact) << "without a density nothing breaks";
}

TEST_F(Village, stands_on_the_grid_on_data_and_nowhere_twice) {
    EXPECT_EQ(fault(hut_at({100, 100})), std::nullopt);
    EXPECT_NE(fault(hut_at({3, 100}))->find("hut 1 at (3, 100) is outside the terrain"), std::string::npos);
    EXPECT_TRUE(fault(hut_at({1e7, 100})));
    data_[20 * kSide + 21] = 0;
    EXPECT_NE(fault(hut_at({100, 100}))->find("no data"), std::string::npos);
    data_[20 * kSide + 21] = 1;

    render::Structures two = hut_at({100, 100});
    two.all.push_back({StructureKind::kHut, {108.9, 100}});
    EXPECT_EQ(fault(two), "hut 2 at (109, 100) stands on hut 1 at (100, 100)");
    two.all[1].at.x = 109.1;
    EXPECT_EQ(fault(two), std::nullopt);
    two.all[1].heading_deg = 45;  // its corner is nearer than its side was
    EXPECT_TRUE(fault(two));

    render::Structures road;
    road.roads.push_back({{{0, 0}, {200, 201}}});
    EXPECT_EQ(fault(road), "point (200, 201) of road 1 is outside the terrain");
}

TEST_F(Village, has_lifts_with_stations_at_both_ends_and_pylons_between) {
    render::Structures structures = hut_at({0, 0});
    add_lift({10, 20}, {10, 500}, structures);
    ASSERT_EQ(structures.lifts.size(), 1u);
    EXPECT_EQ(structures.lifts[0], (render::Lift{1, 7}));
    EXPECT_EQ(structures.all[1].kind, StructureKind::kStation);
    EXPECT_EQ(structures.all[4].kind, StructureKind::kPylon);
    EXPECT_EQ(structures.all[4].at, glm::dvec2(10, 260));
    EXPECT_EQ(structures.all[7].kind, StructureKind::kStation);
    EXPECT_EQ(stations(structures, structures.lifts[0]), std::pair(glm::dvec2(10, 20), glm::dvec2(10, 500)));
    EXPECT_TRUE(fault_of_lift({0, 0}, {59, 0}));
    EXPECT_FALSE(fault_of_lift({0, 0}, {61, 0}));
    EXPECT_TRUE(fault_of_lift({0, 0}, {5001, 0}));
}

}  // namespace
}  // namespace game
