#include "game/controls/catalogue.h"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "game/files/assets.h"

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
        EXPECT_EQ(names, asset_names(kind).value());
        EXPECT_FALSE(names.empty());
    }
}

}  // namespace
}  // namespace game::test
