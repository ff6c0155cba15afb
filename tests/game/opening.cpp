#include "game/session/loaded_world.h"

#include <gtest/gtest.h>

#include "game/scene/material.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

TEST(LoadedWorld, takes_a_scene_by_its_name_and_a_shipped_recording_by_name_and_ending) {
    Overrides overrides;
    overrides.squares = 40;
    const auto scene = open_anything("landslide", overrides);
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->scene.scenario.grid.nx, 41);
    EXPECT_FALSE(scene->watched);
    const auto recording = open_anything("landslide.couloir", overrides);
    ASSERT_TRUE(recording) << recording.error().sentence;
    ASSERT_TRUE(recording->watched);
    EXPECT_EQ(recording->scene.scenario.grid.nx, 81);
    EXPECT_EQ(recording->scene.commands.size(), recording->watched->commands.size());
}

TEST(LoadedWorld, tells_a_torn_recording_and_takes_it_all_the_same) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "torn.couloir";
    record(path, small_scenario(), 30, {});
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - 5);
    const auto loaded = open_anything(path.string(), {});
    ASSERT_TRUE(loaded);
    EXPECT_NE(loaded->told.find("cut off"), std::string::npos);
}

// An old recording looks as new as the program. What the file says is kept: a continuation writes it again.
TEST(LoadedWorld, of_a_recording_looks_as_its_materials_ship_now) {
    const support::TemporaryFolder folder;
    const std::string path = folder.path() / "old.couloir";
    const Material soil = load_material("soil", sim::Model::kBcreInertial).value(),
                   wet = load_material("snow-wet", sim::Model::kBcreInertial).value();
    const Scenario small = small_scenario();
    const auto opened = [&](const Scenario& scenario, LookFrom from) {
        record(path, scenario, 6, {});
        Overrides overrides;
        overrides.look = from;
        const LoadedWorld loaded = open_anything(path, overrides).value();
        EXPECT_EQ(loaded.watched->header.scenario.look.standing, small.look.standing);
        return loaded.scene.scenario.look;
    };
    ASSERT_NE(small.look.rolling, soil.look.rolling);
    EXPECT_EQ(opened(small, LookFrom::kRecorded).rolling, small.look.rolling);
    EXPECT_EQ(opened(small, LookFrom::kShipped).rolling, soil.look.rolling);
    EXPECT_EQ(opened(small, LookFrom::kShipped).flow, soil.look.flow);

    Scenario own = small;
    own.material = "of-my-own";
    EXPECT_EQ(opened(own, LookFrom::kShipped).rolling, small.look.rolling);

    Scenario two = small;
    two.material = "snow-wet";
    two.lower =
        Scenario::Lower{"soil", small.params, std::vector<float>(small.depth.size(), 0.f), {}, {}, {}};
    const render::Look mixed = opened(two, LookFrom::kShipped);
    EXPECT_EQ(mixed.rolling, wet.look.rolling);
    EXPECT_EQ(mixed.lower_rolling, soil.look.rolling);
    EXPECT_EQ(mixed.rock, soil.look.rock);
}

TEST(LoadedWorld, refuses_in_one_sentence_that_names_the_thing) {
    const support::TemporaryFolder folder;
    for (const std::string& wrong : {std::string("nowhere"), std::string("nowhere.couloir"),
                                     (folder.path() / "none.tif").string(), folder.path().string()}) {
        const auto loaded = open_anything(wrong, {});
        ASSERT_FALSE(loaded) << wrong;
        EXPECT_EQ(loaded.error().status, Failure::kUnusable);
        EXPECT_NE(loaded.error().sentence.find(std::filesystem::path(wrong).stem().string()),
                  std::string::npos)
            << loaded.error().sentence;
    }
}

TEST(LoadedWorld, makes_a_playable_hill_of_real_terrain) {
    const auto dem = support::dem_dir();
    if (!dem) GTEST_SKIP() << "COULOIR_DEM_DIR is not set";
    Overrides overrides;
    overrides.squares = 64;
    const auto hill = open_anything((*dem / "alr/alr_utm32n.tif").string(), overrides);
    ASSERT_TRUE(hill) << hill.error().sentence;
    EXPECT_TRUE(hill->scene.scenario.georeference.placed());
    EXPECT_NE(hill->told.find("alr_utm32n.tif"), std::string::npos) << hill->told;
    EXPECT_GT(hill->scene.scenario.trees.density, 0);
    EXPECT_NEAR(hill->scene.scenario.trees.line_m, 2000, 50) << "it is in the Alps";
    EXPECT_FALSE(hill->scene.scenario.woods_act()) << "the file says nothing of a forest";
}

}  // namespace
}  // namespace game::test
