#include "game/app/screenshots.h"

#include <algorithm>
#include <cstdlib>
#include <map>

#include <gtest/gtest.h>

#include "game/base/version.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

// The tEXt chunks of a PNG.
std::map<std::string, std::string> texts_in(const std::string& png) {
    std::map<std::string, std::string> texts;
    constexpr std::size_t kSignature = 8, kAround = 12;  // bytes; around the data of a chunk
    for (std::size_t at = kSignature; at + kAround <= png.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = 256 * length + static_cast<unsigned char>(png[at + i]);
        const std::string data = png.substr(at + 8, length);
        if (png.compare(at + 4, 4, "tEXt") == 0) texts[data.c_str()] = data.substr(data.find('\0') + 1);
        at += length + kAround;
    }
    return texts;
}

class Screenshot : public testing::Test {
  protected:
    Screenshot() {
        setenv("XDG_DATA_HOME", folder_.path().c_str(), 1);
        setenv("HOME", folder_.path().c_str(), 1);
        unsetenv("XDG_CONFIG_HOME");
    }
    fs::path folder() const { return folder_.path() / "couloir/screenshots"; }
    static Outcome<fs::path> wait_for(Screenshots& screenshots) {
        while (true)
            if (auto result = screenshots.result()) return std::move(*result);
    }

    support::TemporaryFolder folder_;
    render::Picture picture_{8, 8, std::vector<std::uint8_t>(8 * 8 * 3, 77)};
};

TEST_F(Screenshot, has_scene_recording_tick_program_and_place_in_its_file) {
    const Scenario scenario = small_scenario();
    ASSERT_TRUE(scenario.georeference.placed());
    const render::Camera camera{{11, 12, 13}, 207, 33, 318, 35};
    Screenshots screenshots;
    ASSERT_TRUE(screenshots.write(picture_, "a", texts_of({scenario, "/home/me/slide.couloir", 90, camera})));
    const auto file = wait_for(screenshots);
    ASSERT_TRUE(file) << file.error().sentence;
    auto texts = texts_in(read_bytes(*file));
    EXPECT_EQ(texts["Title"], scenario.title);
    EXPECT_EQ(texts["Scene"], scenario.scene);
    EXPECT_EQ(texts["Recording"], "slide.couloir") << "without the names of folders at home";
    EXPECT_EQ(texts["Tick"], "90");
    EXPECT_EQ(texts["Time"], "1.500 s");
    EXPECT_EQ(texts["Software"].rfind(kProgram, 0), 0u) << texts["Software"];
    EXPECT_EQ(texts["Camera"],
              "target = [11.000, 12.000, 13.000], azimuth = 207.000, elevation = 33.000, distance = 318.000, "
              "field_of_view = 35.000");
    EXPECT_NE(texts["Place in view"].find(" E, UTM "), std::string::npos) << texts["Place in view"];
    EXPECT_NE(texts["Place of the camera"], texts["Place in view"]);
    for (const char* keyword : {"Camera", "Place in view", "Place of the camera"})
        EXPECT_TRUE(std::all_of(texts[keyword].begin(), texts[keyword].end(), [](char c) {
            return c >= ' ' && c <= '~';
        })) << texts[keyword];
}

TEST_F(Screenshot, has_no_place_where_the_world_has_none) {
    Scenario scenario = small_scenario();
    scenario.georeference = {};
    for (const auto& [keyword, text] : texts_of({scenario, {}, 0, {}})) {
        EXPECT_EQ(keyword.find("Place"), std::string::npos);
        EXPECT_NE(keyword, "Recording");
    }
}

TEST_F(Screenshot, overwrites_none_of_the_same_second) {
    Screenshots screenshots;
    for (int i = 0; i < 6; ++i) ASSERT_TRUE(screenshots.write(picture_, "a", {}));
    std::vector<std::string> names;
    for (int i = 0; i < 6; ++i) names.push_back(wait_for(screenshots).value().filename().string());
    EXPECT_FALSE(screenshots.result());
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names,
              (std::vector<std::string>{"a-2.png", "a-3.png", "a-4.png", "a-5.png", "a-6.png", "a.png"}));
}

TEST_F(Screenshot, is_whole_if_the_program_ends_meanwhile) {
    { EXPECT_TRUE(Screenshots().write(picture_, "a", {})); }
    EXPECT_GT(fs::file_size(folder() / "a.png"), 0u);
}

TEST_F(Screenshot, says_that_its_folder_cannot_be_made) {
    write_bytes(folder_.path() / "couloir", "a file");
    Screenshots screenshots;
    ASSERT_TRUE(screenshots.write(picture_, "a", {}));
    const auto refused = wait_for(screenshots);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().status, Failure::kMachine);
    EXPECT_NE(refused.error().sentence.find(folder().string()), std::string::npos)
        << refused.error().sentence;
}

}  // namespace
}  // namespace game::test
