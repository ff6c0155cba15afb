#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "game/files/text_file.h"
#include "game/recording/recording_file.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

std::size_t entries_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

// Below a regular file nobody can write, the superuser neither.
fs::path unwritable(const support::TemporaryFolder& folder) {
    write_bytes(folder.path() / "file", "kept");
    return folder.path() / "file" / "x";
}

TEST(WriteText, makes_its_folder_and_leaves_nothing_beside_the_file) {
    const support::TemporaryFolder folder;
    const fs::path path = folder.path() / "a" / "b.txt";
    ASSERT_TRUE(write_text(path, std::string_view("one\0two", 7)));
    EXPECT_EQ(read_bytes(path), std::string("one\0two", 7));
    ASSERT_TRUE(write_text(path, "three"));
    EXPECT_EQ(read_bytes(path), "three");
    EXPECT_EQ(entries_in(path.parent_path()), 1u);
}

TEST(WriteText, into_what_cannot_be_written_is_the_machines_failure_and_leaves_no_half_file) {
    const support::TemporaryFolder folder;
    fs::create_directories(folder.path() / "folder" / "full");
    // A path below a file, and a folder that stands where the file should.
    for (const fs::path& path : {unwritable(folder), folder.path() / "folder"}) {
        const auto written = write_text(path, "text");
        ASSERT_FALSE(written) << path;
        EXPECT_EQ(written.error().status, Failure::kMachine);
        EXPECT_NE(written.error().sentence.find((folder.path() / "f").string()), std::string::npos)
            << written.error().sentence;
    }
    EXPECT_EQ(read_bytes(folder.path() / "file"), "kept");
    EXPECT_EQ(entries_in(folder.path()), 2u);
}

TEST(MakeFolder, says_what_stands_in_its_way) {
    const support::TemporaryFolder folder;
    const fs::path below = unwritable(folder);
    for (const fs::path& path : {below, below.parent_path()}) {
        const auto made = make_folder(path);
        ASSERT_FALSE(made);
        EXPECT_EQ(made.error().status, Failure::kMachine);
        EXPECT_EQ(made.error().sentence.rfind(path.string() + ": ", 0), 0u) << made.error().sentence;
    }
}

TEST(Recorder, that_cannot_write_is_the_machines_failure) {
    const support::TemporaryFolder folder;
    const auto recorder = record_into(unwritable(folder), small_scenario());
    ASSERT_FALSE(recorder);
    EXPECT_EQ(recorder.error().status, Failure::kMachine);
    const auto full = record_into("/dev/full", small_scenario());
    ASSERT_FALSE(full);
    EXPECT_EQ(full.error().status, Failure::kMachine);
    EXPECT_NE(full.error().sentence.find("/dev/full: cannot be written: "), std::string::npos)
        << full.error().sentence;
}

// The earlier recording of that name is worth more than a header without states.
TEST(Recorder, is_not_begun_by_a_run_that_cannot_draw) {
    const support::TemporaryFolder folder;
    const fs::path file = folder.path() / "kept.couloir", frames = folder.path() / "frames";
    write_bytes(file, "kept");
    const Finished run = couloir(
        {"run", "landslide", "--seconds", "0.1", "--record", file, "--frames", frames, "--gl", "device:255"});
    EXPECT_EQ(run.status, 3) << run.err;
    EXPECT_EQ(read_bytes(file), "kept");
}

TEST(Recorder, writes_names_that_are_not_utf_8_as_well_as_it_can) {
    const support::TemporaryFolder folder;
    Scenario scenario = small_scenario();
    scenario.terrain = "h\xfcgel.asc";  // Latin-1, as old files are named
    const auto path = folder.path() / "latin.couloir";
    record(path, scenario, 6, {});
    const auto recording = read_recording(path);
    ASSERT_TRUE(recording) << recording.error().sentence;
    EXPECT_EQ(recording->header.scenario.terrain, "h\xef\xbf\xbdgel.asc");
}

}  // namespace
}  // namespace game::test
