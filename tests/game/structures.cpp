#include "game/scene/structures.h"

#include <gtest/gtest.h>

#include "tests/support/worlds.h"

// What stands in a world, as it is drawn.
namespace game {
namespace {

using render::Structure;
using render::StructureKind;
using render::StructureState;

constexpr int kSide = 41;  // vertices
constexpr float kCell = 5;

TEST(Lifts, have_stations_that_are_neither_too_near_nor_too_far) {
    EXPECT_TRUE(fault_of_lift({0, 0}, {59, 0}));
    EXPECT_FALSE(fault_of_lift({0, 0}, {61, 0}));
    EXPECT_TRUE(fault_of_lift({0, 0}, {5001, 0}));
}

// What stands in a world.
class DrawnThings : public testing::Test {
  protected:
    DrawnThings() { sim::things_of(state_); }
    render::Structures drawn() const { return structures_in(sim::view(state_), first_); }
    sim::Thing& add(const sim::Thing& thing) { return state_.things->list.emplace_back(thing); }

    // Level ground without a standing layer.
    sim::State state_ = sim::make_state(support::plane(kSide - 1, kCell, 0, 0).world(), {});
    std::vector<float> first_ = std::vector<float>(state_.grid.size());
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
    first_.assign(first_.size(), 2);
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
    EXPECT_EQ(structures.lifts, (std::vector<render::Lift>{{0, 3}, {3, 3}}));
    ASSERT_EQ(structures.roads.size(), 2u);
    EXPECT_EQ(structures.roads[0], (render::Road{{{0, 0}, {50, 0}, {90, 30}}, 8}));
    EXPECT_EQ(structures.nets, (std::vector<render::Net>{{{5, 5}, {9, 5}, 3, StructureState::kIntact}}));
}

TEST_F(DrawnThings, come_and_go) {
    add({.x = 60, .y = 70, .length = 20, .width = 12, .height = 8, .strength = 10});
    StructureWatch watch(sim::view(state_));
    EXPECT_EQ(watch.structures().all.size(), 1u);
    state_.things->list.clear(), ++state_.things->changed;
    watch.watch(sim::view(state_));
    EXPECT_TRUE(watch.structures().empty());
}

// As in a world where nothing was ever placed.
TEST_F(DrawnThings, are_gone_where_a_world_has_none) {
    add({.x = 60, .y = 70, .length = 20, .width = 12, .height = 8, .strength = 10});
    StructureWatch watch(sim::view(state_));
    ASSERT_FALSE(watch.structures().empty());
    state_.things.reset();
    watch.watch(sim::view(state_));
    EXPECT_TRUE(watch.structures().empty());
}

TEST_F(DrawnThings, change_their_states_while_none_comes_or_goes) {
    add({.kind = sim::ThingKind::kRoad, .x = 0, .y = 0, .to_x = 50, .to_y = 0, .width = 8});
    add({.kind = sim::ThingKind::kNet, .x = 5, .y = 5, .to_x = 9, .to_y = 5, .height = 3, .strength = 30});
    add({.x = 60, .y = 70, .length = 20, .width = 12, .height = 8, .strength = 10});
    StructureWatch watch(sim::view(state_));
    for (const std::int64_t load : {0, 5100, 10'000}) {
        for (sim::Thing& thing : state_.things->list) thing.load = load;
        watch.watch(sim::view(state_));
        EXPECT_EQ(watch.structures(), drawn()) << load;
    }
    EXPECT_EQ(watch.structures().all.back().state, StructureState::kDestroyed);
}

}  // namespace
}  // namespace game
