#include "game/controls/catalogue.h"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "game/files/assets.h"
#include "game/scene/scene.h"

namespace game::test {
namespace {

TEST(Catalogue, has_everything_that_ships_with_a_title_and_a_file_that_opens) {
    const auto catalogue = read_catalogue();
    ASSERT_TRUE(catalogue) << catalogue.error().sentence;
    for (const auto& [kind, entries] : {std::pair{AssetKind::kScene, &catalogue->scenes},
                                        std::pair{AssetKind::kMaterial, &catalogue->materials},
                                        std::pair{AssetKind::kRecording, &catalogue->recordings}}) {
        std::vector<std::string> names;
        for (const Catalogue::Entry& entry : *entries) {
            names.push_back(entry.name);
            EXPECT_TRUE(std::filesystem::is_regular_file(entry.file)) << entry.file;
            EXPECT_NE(entry.title, "") << entry.name;
            // A material's name may be all there is to say.
            EXPECT_TRUE(kind == AssetKind::kMaterial || entry.title != entry.name) << entry.name;
        }
        std::ranges::sort(names);
        EXPECT_EQ(names, asset_names(kind).value());
        EXPECT_FALSE(names.empty());
    }
}

TEST(Catalogue, has_challenges_first_and_flow_demos_last) {
    const auto scenes = read_catalogue()->scenes;
    EXPECT_TRUE(std::ranges::is_sorted(scenes, {}, &Catalogue::Entry::kind));
    for (const Catalogue::Entry& scene : scenes) {
        const Scenario scenario = load_scene(scene.name, {})->scenario;
        EXPECT_EQ(scene.kind == Catalogue::Kind::kChallenge, scenario.goal.has_value()) << scene.name;
        EXPECT_EQ(scene.kind == Catalogue::Kind::kFlowDemo, scenario.flow.has_value()) << scene.name;
    }
}

}  // namespace
}  // namespace game::test
