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

// What stands in a world.
class DrawnThings : public Village {
  protected:
    DrawnThings() { sim::things_of(state_); }
    render::Structures drawn() const {
        render::Structures structures;
        add_things(sim::view(state_), first_, structures);
        return structures;
    }
    sim::Thing& add(const sim::Thing& thing) { return state_.things->list.emplace_back(thing); }

    sim::State state_ = level(0);
    std::vector<float> first_ = std::vector<float>(grid_.size());
};

TEST_F(DrawnThings, are_houses_of_their_size_material_and_state) {
    sim::Thing& house = add({.x = 60, .y = 70, .length = 20, .width = 12, .height = 8, .strength = 10});
    const Structure drawn_house = drawn().all.at(0);
    EXPECT_EQ(drawn_house, (Structure{StructureKind::kHouse,
                                      {60, 70},
                                      0,
                                      StructureState::kIntact,
                                      20,
                                      12,
                                      8,
                                      render::HouseMaterial::kBrick}));
    house.load = 5100;
    EXPECT_EQ(drawn().all.at(0).state, StructureState::kDamaged);
    for (int y = 10; y < 18; ++y)
        for (int x = 8; x < 16; ++x) state_.rolling(x, y) = 9;
    EXPECT_EQ(drawn().all.at(0).state, StructureState::kBuried);
    first_.assign(grid_.size(), 2);
    EXPECT_EQ(drawn().all.at(0).state, StructureState::kDamaged) << "7 m above the first surface";
    house.load = 10'000;
    EXPECT_EQ(drawn().all.at(0).state, StructureState::kDestroyed);
}

TEST_F(DrawnThings, are_lifts_of_one_command_and_roads_of_pieces_that_meet) {
    for (const std::int64_t group : {1, 2})
        for (const auto kind : {sim::ThingKind::kStation, sim::ThingKind::kPylon, sim::ThingKind::kStation})
            add({.kind = kind, .x = 10, .y = 20, .height = 7, .strength = 10, .group = group});
    add({.kind = sim::ThingKind::kRoad, .x = 0, .y = 0, .to_x = 50, .to_y = 0, .width = 8, .group = 3});
    add({.kind = sim::ThingKind::kRoad, .x = 50, .y = 0, .to_x = 90, .to_y = 30, .width = 8, .group = 4});
    add({.kind = sim::ThingKind::kRoad, .x = 50, .y = 60, .to_x = 90, .to_y = 60, .width = 8, .group = 5});
    add({.kind = sim::ThingKind::kNet,
         .x = 5,
         .y = 5,
         .to_x = 9,
         .to_y = 5,
         .height = 3,
         .strength = 30,
         .group = 6});
    const render::Structures structures = drawn();
    EXPECT_EQ(structures.lifts, (std::vector<render::Lift>{{0, 3, true}, {3, 3, true}}));
    ASSERT_EQ(structures.roads.size(), 2u);
    EXPECT_EQ(structures.roads[0], (render::Road{{{0, 0}, {50, 0}, {90, 30}}, 8}));
    EXPECT_EQ(structures.nets, (std::vector<render::Net>{{{5, 5}, {9, 5}, 3, StructureState::kIntact}}));
}

TEST_F(DrawnThings, come_after_the_structures_that_are_a_view) {
    add({.x = 60, .y = 70, .length = 20, .width = 12, .height = 8, .strength = 10});
    StructureWatch watch(hut_at({150, 150}), sim::view(state_));
    ASSERT_EQ(watch.structures().all.size(), 2u);
    state_.things->list.clear();
    watch.watch(sim::view(state_), {}, {});
    EXPECT_EQ(watch.structures(), hut_at({150, 150}));
}

TEST_F(DrawnThings, change_their_states_while_none_comes_or_goes) {
    add({.kind = sim::ThingKind::kRoad, .x = 0, .y = 0, .to_x = 50, .to_y = 0, .width = 8});
    add({.kind = sim::ThingKind::kNet, .x = 5, .y = 5, .to_x = 9, .to_y = 5, .height = 3, .strength = 30});
    add({.x = 60, .y = 70, .length = 20, .width = 12, .height = 8, .strength = 10});
    StructureWatch watch(hut_at({150, 150}), sim::view(state_));
    for (const std::int64_t load : {0, 5100, 10'000}) {
        for (sim::Thing& thing : state_.things->list) thing.load = load;
        watch.watch(sim::view(state_), {}, {});
        render::Structures anew = hut_at({150, 150});
        add_things(sim::view(state_), first_, anew);
        EXPECT_EQ(watch.structures(), anew) << load;
    }
    EXPECT_EQ(watch.structures().all.back().state, StructureState::kDestroyed);
}

}  // namespace
}  // namespace game
