// `couloir release` as people call it.

#include <filesystem>

#include <gtest/gtest.h>

#include "game/files/text_file.h"
#include "game/recording/json_values.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

TEST(ReleaseCommand, tells_the_same_as_table_as_json_and_in_its_file) {
    support::TemporaryFolder folder;
    const std::string file = (folder.path() / "areas.geojson").string(),
                      map = (folder.path() / "areas.png").string();
    const Finished finished =
        couloir({"release", "alpine-valley", "--grid", "60", "--json", "--out", file, "--map", map});
    ASSERT_EQ(finished.status, 0) << finished.err;
    const Json told = Json::parse(finished.out), written = Json::parse(read_text(file).value());
    ASSERT_GT(told["areas"].size(), 3u);
    ASSERT_EQ(written["features"].size(), told["areas"].size());
    double volume = 0;
    for (std::size_t i = 0; i < told["areas"].size(); ++i) {
        const Json& area = told["areas"][i];
        EXPECT_EQ(area["number"], i + 1);
        for (const auto& [name, value] : area.items())
            EXPECT_EQ(written["features"][i]["properties"][name], value) << name;
        volume += area["volume_m3"].get<double>();
        EXPECT_GE(area["slope_deg"], 25) << "a majority of nine cells may take in a gentler one";
    }
    EXPECT_NEAR(told["volume_m3"].get<double>(), volume, static_cast<double>(told["areas"].size()));
    EXPECT_GT(std::filesystem::file_size(map), 10'000u);
    const Finished table = couloir({"release", "alpine-valley", "--grid", "60", "--thickness", "2"});
    EXPECT_NE(table.out.find(" release areas on "), std::string::npos);
    EXPECT_NE(table.out.find("volume, m3"), std::string::npos);
}

TEST(ReleaseCommand, ends_with_1_where_nothing_may_let_go_and_with_2_if_it_cannot_be_meant) {
    const Finished none = couloir({"release", "alpine-valley", "--grid", "60", "--slope", "85:90"});
    EXPECT_EQ(none.status, 1);
    EXPECT_NE(none.out.find("0 release areas"), std::string::npos);
    for (const std::vector<std::string>& wrong :
         {std::vector<std::string>{"release", "alpine-valley", "--slope", "40:30"},
          {"release", "alpine-valley", "--slope", "30"},
          {"release", "nowhere.tif"},
          {"release", "alpine-valley", "--forest", "nowhere.tif"},
          {"release", "alpine-valley", "--least-area", "-1"}}) {
        const Finished refused = couloir(wrong);
        EXPECT_EQ(refused.status, 2) << refused.err;
        EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    }
}

}  // namespace
}  // namespace game::test
