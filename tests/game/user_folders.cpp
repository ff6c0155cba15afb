#include "game/files/user_folders.h"

#include <cstdlib>
#include <regex>

#include <gtest/gtest.h>

#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

class UserFolders : public testing::Test {
  protected:
    UserFolders() {
        setenv("HOME", home().c_str(), 1);
        setenv("XDG_DATA_HOME", (folder_.path() / "data").c_str(), 1);
        unsetenv("XDG_CONFIG_HOME");
        fs::create_directories(home() / ".config");
    }
    fs::path home() const { return folder_.path() / "home"; }
    void write_settings(const std::string& text) { write_bytes(home() / ".config/user-dirs.dirs", text); }

    support::TemporaryFolder folder_;
};

TEST_F(UserFolders, take_screenshots_to_the_pictures_that_the_desktop_names) {
    const fs::path beside = folder_.path() / "data/couloir/screenshots";
    EXPECT_EQ(screenshots_folder().value(), beside);
    write_settings(
        "# a comment\nXDG_PICTURES_DIR=\"$HOME/My \\\"Bilder\\\"\"\nXDG_MUSIC_DIR=\"$HOME/Music\"\n");
    EXPECT_EQ(screenshots_folder().value(), beside) << "the folder does not exist";
    fs::create_directories(home() / "My \"Bilder\"");
    EXPECT_EQ(screenshots_folder().value(), home() / "My \"Bilder\"/Couloir");
    write_settings("XDG_PICTURES_DIR=\"" + folder_.path().string() + "\"\n");
    EXPECT_EQ(screenshots_folder().value(), folder_.path() / "Couloir");
    for (const char* none : {"\"$HOME/\"", "\"$HOME\"", "\"Pictures\"", "\"", "", "$HOME/Pictures"}) {
        write_settings(std::string("XDG_PICTURES_DIR=") + none + "\n");
        EXPECT_EQ(screenshots_folder().value(), beside) << none;
    }
}

TEST_F(UserFolders, are_none_without_a_home) {
    unsetenv("HOME");
    EXPECT_TRUE(screenshots_folder());
    unsetenv("XDG_DATA_HOME");
    EXPECT_EQ(screenshots_folder().error().status, Failure::kMachine);
    EXPECT_EQ(data_folder("shared").error().status, Failure::kMachine);
}

TEST_F(UserFolders, name_by_scene_date_and_time) {
    EXPECT_TRUE(std::regex_match(dated_name("winter-valley"),
                                 std::regex(R"(winter-valley-\d{4}-\d\d-\d\d-\d\d-\d\d-\d\d)")))
        << dated_name("winter-valley");
    EXPECT_EQ(file_name_of("../a b\xc3\xa4"), "---a-b--");
    EXPECT_EQ(file_name_of(""), "scene");
}

TEST_F(UserFolders, get_new_names_that_overwrite_nothing) {
    const fs::path in = folder_.path() / "made/here";
    EXPECT_EQ(new_file(in, "a", "png").value(), in / "a.png");
    EXPECT_EQ(new_file(in, "a", "png").value(), in / "a-2.png");
    EXPECT_EQ(new_file(in, "a", "png").value(), in / "a-3.png");
    EXPECT_EQ(new_folder(in, "b").value(), in / "b");
    EXPECT_EQ(new_folder(in, "b").value(), in / "b-2");
    const auto refused = new_file(in / "a.png", "c", "png");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().status, Failure::kMachine);
    EXPECT_NE(refused.error().sentence.find((in / "a.png").string()), std::string::npos);
}

}  // namespace
}  // namespace game::test
