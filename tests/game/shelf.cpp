// Files that a person has made: their list, other names, the trash.
#include "game/files/shelf.h"

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "game/files/text_file.h"
#include "game/files/trash.h"
#include "game/recording/recording_length.h"
#include "render/pictures/fit.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

class Shelf : public testing::Test {
  protected:
    Shelf() {
        setenv("XDG_DATA_HOME", folder_.path().c_str(), 1);
        fs::create_directories(recordings());
    }
    fs::path recordings() const { return folder_.path() / "couloir/recordings"; }
    fs::path trash() const { return folder_.path() / "Trash"; }
    fs::path put(const std::string& name, const std::string& text = "x") const {
        std::ofstream(recordings() / name) << text;
        return recordings() / name;
    }
    support::TemporaryFolder folder_;
};

TEST_F(Shelf, lists_the_newest_first_and_no_empty_or_other_file) {
    put("old.couloir");
    put("new.couloir");
    put("being-made.couloir", "");
    put("new.png");
    fs::create_directory(recordings() / "folder.couloir");
    fs::last_write_time(recordings() / "old.couloir",
                        fs::file_time_type::clock::now() - std::chrono::hours(2));
    const auto all = shelf(ShelfKind::kRecording, 10);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].file, recordings() / "new.couloir");
    EXPECT_EQ(all[1].file, recordings() / "old.couloir");
    EXPECT_NEAR(static_cast<double>(all[0].written - all[1].written), 7200, 5);
    EXPECT_EQ(shelf(ShelfKind::kRecording, 1).size(), 1u);
}

TEST_F(Shelf, tells_how_long_a_recording_is_from_its_ends) {
    const std::string header =
        R"({"format":"couloir","title":"a \"tick_s\":5, b","physics":{"tick_s":0.25,"x":1}})"
        "\n";
    const std::string rest = R"({"tick":6,"hash":"00"})"
                             "\n"
                             R"({"tick":12,"hash":"00"})"
                             "\n";
    EXPECT_EQ(length_of_recording(put("a.couloir", header + rest)), 3);
    EXPECT_EQ(length_of_recording(put("a.couloir", header + rest + R"({"tick":99,"ha)")), 3)
        << "of a killed session";
    EXPECT_EQ(length_of_recording(put("a.couloir", header + rest +
                                                       R"({"end":14})"
                                                       "\n")),
              3.5);
    const std::string ground(200'000, '0');  // which it need not read
    EXPECT_EQ(length_of_recording(put("a.couloir", header + ground + "\n" + rest)), 3);
    for (const std::string& none : {std::string(), std::string("x"), header, header + "{}\n",
                                    header + R"({"tick":"6"})"
                                             "\n",
                                    header + R"({"tick":-6})"
                                             "\n",
                                    "{}\n" + rest, header + "\n" + ground + "\n"})
        EXPECT_EQ(length_of_recording(put("a.couloir", none)), std::nullopt) << none.substr(0, 90);
    EXPECT_EQ(length_of_recording(recordings() / "none"), std::nullopt);
}

TEST_F(Shelf, renames_a_recording_and_its_picture_and_loses_nothing) {
    const fs::path file = put("a.couloir", "a recording");
    put("a.png", "a picture");
    put("a.camera.toml", "a path");
    const auto renamed = rename_on_shelf(file, " The big one, 2 m – größer ");
    ASSERT_TRUE(renamed) << renamed.error().sentence;
    EXPECT_EQ(*renamed, recordings() / "The big one, 2 m – größer.couloir");
    EXPECT_EQ(read_text(*renamed).value(), "a recording");
    EXPECT_EQ(read_text(picture_of(*renamed)).value(), "a picture");
    EXPECT_EQ(read_text(camera_path_of(*renamed)).value(), "a path");
    EXPECT_FALSE(fs::exists(file) || fs::exists(picture_of(file)) || fs::exists(camera_path_of(file)));

    const fs::path other = put("b.couloir", "another");
    const auto taken = rename_on_shelf(other, "The big one, 2 m – größer");
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().status, Failure::kUnusable);
    EXPECT_EQ(read_text(*renamed).value(), "a recording");
    EXPECT_EQ(read_text(other).value(), "another");
    EXPECT_EQ(rename_on_shelf(other, "b"), other) << "as it is";
    for (const std::string& none :
         {std::string(), std::string("  "), std::string("../c"), std::string(".c"), std::string("a/b"),
          std::string("c\nd"), std::string(201, 'c'), std::string("what?")}) {
        EXPECT_EQ(rename_on_shelf(other, none).error().status, Failure::kUnusable) << none;
        EXPECT_TRUE(fs::exists(other));
    }
    EXPECT_EQ(rename_on_shelf(recordings() / "none.couloir", "d").error().status, Failure::kMachine);
}

TEST_F(Shelf, throws_into_the_trash_of_the_desktop_from_where_it_can_come_back) {
    for (int i = 0; i < 3; ++i) {
        const fs::path file = put("ä 1.couloir", "number " + std::to_string(i));
        put("ä 1.png");
        const auto thrown = throw_away(file);
        ASSERT_TRUE(thrown) << thrown.error().sentence;
        EXPECT_FALSE(fs::exists(file) || fs::exists(picture_of(file)));
    }
    for (const auto& [name, number] :
         {std::pair("ä 1.couloir", 0), {"ä 1-2.couloir", 1}, {"ä 1-3.couloir", 2}}) {
        EXPECT_EQ(read_text(trash() / "files" / name).value(), "number " + std::to_string(number));
        const std::string info = read_text(trash() / "info" / (std::string(name) + ".trashinfo")).value();
        EXPECT_EQ(
            info.rfind("[Trash Info]\nPath=" + recordings().string() + "/%C3%A4%201.couloir\nDeletionDate=20",
                       0),
            0u)
            << info;
    }
}

TEST_F(Shelf, keeps_what_cannot_be_thrown_away) {
    const fs::path file = put("a.couloir");
    std::ofstream(trash()) << "a file where a folder should be";
    const auto kept = throw_away(file);
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().status, Failure::kMachine);
    EXPECT_EQ(kept.error().sentence.rfind(file.string() + ": cannot be moved to the trash: ", 0), 0u)
        << kept.error().sentence;
    EXPECT_TRUE(fs::exists(file));
    fs::remove(trash());
    EXPECT_FALSE(throw_away(recordings() / "none.couloir"));
    EXPECT_TRUE(fs::is_empty(trash() / "info")) << "nothing is announced that did not come";
}

TEST(FittedImage, is_the_middle_of_the_image_each_pixel_the_mean_of_what_it_covers) {
    // Six columns and two rows; the outer columns do not fit into a square of two pixels.
    const std::vector<std::uint8_t> pixels{0, 0, 10, 20, 0, 0,  //
                                           0, 0, 30, 60, 0, 0};
    EXPECT_EQ(render::fitted(pixels, {6, 2, 1}, 2, 2), (std::vector<std::uint8_t>{10, 20, 30, 60}));
    EXPECT_EQ(render::fitted(pixels, {6, 2, 1}, 1, 1), (std::vector<std::uint8_t>{30}));
    EXPECT_EQ(render::fitted(pixels, {6, 2, 1}, 8, 4).size(), 32u) << "larger than it is";
    EXPECT_EQ(render::fitted(std::vector<std::uint8_t>{1, 2, 3}, {1, 1, 3}, 2, 1),
              (std::vector<std::uint8_t>{1, 2, 3, 1, 2, 3}));
}

}  // namespace
}  // namespace game::test
