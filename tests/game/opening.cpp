#include "game/session/opening.h"

#include <gtest/gtest.h>

#include "tests/game/recording_files.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

TEST(Opening, takes_a_scene_by_its_name_and_a_shipped_recording_by_name_and_ending) {
    Wishes wishes;
    wishes.squares = 40;
    const auto scene = open_anything("landslide", wishes);
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->scene.start.grid.nx, 41);
    EXPECT_FALSE(scene->watched);
    const auto recording = open_anything("landslide.couloir", wishes);
    ASSERT_TRUE(recording) << recording.error().sentence;
    ASSERT_TRUE(recording->watched);
    EXPECT_EQ(recording->scene.start.grid.nx, 81);
    EXPECT_EQ(recording->scene.commands.size(), recording->watched->commands.size());
}

TEST(Opening, tells_a_torn_recording_and_takes_it_all_the_same) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "torn.couloir";
    record(path, small_start(), 30, {});
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - 5);
    const auto opening = open_anything(path.string(), {});
    ASSERT_TRUE(opening);
    EXPECT_NE(opening->told.find("torn off"), std::string::npos);
}

TEST(Opening, refuses_in_one_sentence_that_names_the_thing) {
    const support::TemporaryFolder folder;
    for (const std::string& wrong : {std::string("nowhere"), std::string("nowhere.couloir"),
                                     (folder.path() / "none.tif").string(), folder.path().string()}) {
        const auto opening = open_anything(wrong, {});
        ASSERT_FALSE(opening) << wrong;
        EXPECT_EQ(opening.error().status, Failure::kUnusable);
        EXPECT_NE(opening.error().sentence.find(std::filesystem::path(wrong).stem().string()),
                  std::string::npos)
            << opening.error().sentence;
    }
}

TEST(Opening, makes_a_playable_hill_of_real_terrain) {
    const auto dem = support::dem_dir();
    if (!dem) GTEST_SKIP() << "COULOIR_DEM_DIR is not set";
    Wishes wishes;
    wishes.squares = 64;
    const auto hill = open_anything((*dem / "alr/alr_utm32n.tif").string(), wishes);
    ASSERT_TRUE(hill) << hill.error().sentence;
    EXPECT_TRUE(hill->scene.start.georeference.placed());
    EXPECT_NE(hill->told.find("alr_utm32n.tif"), std::string::npos) << hill->told;
}

}  // namespace
}  // namespace game::test
