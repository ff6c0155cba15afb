// `couloir terrain generate` as people call it.

#include <filesystem>

#include <gtest/gtest.h>

#include "game/recording/json_values.h"
#include "terrains/dem_gdal.h"
#include "terrains/generators.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

TEST(GenerateTerrain, writes_heights_and_layers_that_read_back_as_they_were_made) {
    support::TemporaryFolder folder;
    const std::string file = (folder.path() / "m.tif").string(), layers = (folder.path() / "layers").string();
    const Finished finished =
        couloir({"terrain", "generate", "massif", "--seed", "18446744073709551615", "--grid", "40", "--set",
                 "relief=700", "--out", file, "--layers", layers, "--json"});
    ASSERT_EQ(finished.status, 0) << finished.err;
    const Json told = Json::parse(finished.out);
    EXPECT_EQ(told["squares"], 40);
    EXPECT_EQ(told["seed"], 18446744073709551615u);
    double shares = 0;
    for (const auto& [slope, share] : told["slopes_deg"].items()) shares += share.get<double>();
    EXPECT_NEAR(shares, 1, 1e-9);
    const auto* massif = terrains::find_generator("massif");
    std::vector<double> values;
    for (const auto& number : massif->numbers)
        values.push_back(number.name == std::string("relief") ? 700 : number.usual);
    const auto made = massif->make(values, 18446744073709551615u, 40);
    ASSERT_TRUE(made);
    const auto read = terrains::read_dem(file, terrains::GridChoice::kOwn);
    ASSERT_TRUE(read) << read.error();
    EXPECT_EQ(read->surface, made->terrain.surface);
    for (const auto& layer : made->layers) {
        EXPECT_TRUE(std::filesystem::exists(layers + "/" + layer.name + ".tif"));
        if (layer.unit == std::string("m²")) continue;  // read_dem() reads heights
        const auto again = terrains::read_dem(layers + "/" + layer.name + ".tif", terrains::GridChoice::kOwn);
        ASSERT_TRUE(again) << again.error();
        EXPECT_EQ(again->surface, layer.values) << layer.name;
    }
    EXPECT_TRUE(std::filesystem::exists(layers + "/cover.tif"));
}

TEST(GenerateTerrain, refuses_in_one_sentence_what_it_cannot_make) {
    support::TemporaryFolder folder;
    const std::string file = (folder.path() / "m.asc").string();
    for (const std::vector<std::string>& wrong : {std::vector<std::string>{"moon"},
                                                  {"massif", "--seed", "-1"},
                                                  {"massif", "--seed", "18446744073709551616"},
                                                  {"massif", "--grid", "7"},
                                                  {"massif", "--set", "relief"},
                                                  {"massif", "--set", "relief=9000"},
                                                  {"massif", "--set", "height=10"},
                                                  {"massif", "--set", "relief=2000"},
                                                  {"alpine-valley", "--seed", "3"}}) {
        std::vector<std::string> arguments{"terrain", "generate", "--out", file};
        arguments.insert(arguments.end(), wrong.begin(), wrong.end());
        const Finished refused = couloir(arguments);
        EXPECT_EQ(refused.status, 2) << refused.err;
        EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
        EXPECT_FALSE(std::filesystem::exists(file));
    }
    EXPECT_EQ(couloir({"terrain", "generate", "massif", "--out", "m.png"}).status, 2);
    EXPECT_EQ(couloir({"terrain"}).status, 2);
}

}  // namespace
}  // namespace game::test
