#include "game/controls/catalogue.h"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "game/files/assets.h"
#include "game/scene/scene.h"
#include "render/pictures/png.h"

namespace game::test {
namespace {

TEST(Catalogue, has_everything_that_ships_with_a_title_and_a_file_that_opens) {
    const auto catalogue = read_catalogue();
    ASSERT_TRUE(catalogue) << catalogue.error().sentence;
    for (const auto& [kind, entries] : {std::pair{AssetKind::kScene, &catalogue->scenes},
                                        std::pair{AssetKind::kMaterial, &catalogue->materials},
                                        std::pair{AssetKind::kRecording, &catalogue->recordings},
                                        std::pair{AssetKind::kLesson, &catalogue->lessons}}) {
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

TEST(Catalogue, says_a_sentence_of_each_scene_and_how_hard_each_challenge_is) {
    const auto scenes = read_catalogue()->scenes;
    for (const Catalogue::Entry& scene : scenes) {
        EXPECT_TRUE(scene.about.ends_with('.')) << scene.name;
        EXPECT_EQ(scene.difficulty > 0, scene.kind == Catalogue::Kind::kChallenge) << scene.name;
    }
}

TEST(Catalogue, has_a_picture_of_each_scene_and_no_other) {
    constexpr std::uintmax_t kMostBytes = 1'400'000;  // of all together
    const auto scenes = read_catalogue()->scenes;
    std::uintmax_t bytes = 0;
    for (const Catalogue::Entry& scene : scenes) {
        const auto file = std::filesystem::path(scene.file).replace_extension(".jpg");
        if (!scene.harder_than.empty()) {  // it has the picture of the other one
            EXPECT_FALSE(std::filesystem::exists(file)) << file;
            continue;
        }
        ASSERT_TRUE(std::filesystem::exists(file))
            << file << " is missing: draw it with build/release/bin/draw_scene_pictures " << scene.name;
        const auto picture = render::read_jpeg(file, 3);
        ASSERT_TRUE(picture) << picture.error();
        EXPECT_EQ(picture->width, Catalogue::kPictureWidth) << file;
        EXPECT_EQ(picture->height, Catalogue::kPictureHeight) << file;
        bytes += std::filesystem::file_size(file);
    }
    EXPECT_LT(bytes, kMostBytes);
    for (const auto& entry : std::filesystem::directory_iterator(scenes.front().file.parent_path()))
        if (entry.path().extension() != ".toml") {
            EXPECT_TRUE(
                std::filesystem::exists(std::filesystem::path(entry.path()).replace_extension(".toml")))
                << entry.path() << " is of no scene";
        }
}

}  // namespace
}  // namespace game::test
