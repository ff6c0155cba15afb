#include "game/files/file_use.h"

#include <filesystem>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

class FileUseTest : public testing::Test {
  protected:
    FileUseTest() {
        fs::create_directories(at("a/b"));
        fs::create_directory_symlink("a/b", at("short"));
        write_bytes(at("a/b/file"), "kept");
        fs::create_hard_link(at("a/b/file"), at("hard"));
        fs::create_symlink("a/b/file", at("soft"));
        fs::create_symlink("soft", at("softer"));
        fs::create_symlink("a/b/new", at("nowhere"));
        fs::create_symlink("loop", at("loop"));
    }
    fs::path at(const std::string& name) const { return folder_.path() / name; }

  private:
    support::TemporaryFolder folder_;
};

bool is_refused(const FileUse& use) {
    const auto checked = use.check();
    return !checked && checked.error().status == Failure::kUnusable;
}

TEST_F(FileUseTest, knows_a_file_by_all_its_names) {
    const std::vector<std::string> of_file{"a/b/file", "a/b/../b/./file", "short/file", "hard",
                                           "soft",     "softer",          "a//b/file"};
    for (const std::string& one : of_file)
        for (const std::string& other : of_file) {
            EXPECT_TRUE(is_refused(FileUse().reads(at(one)).writes("--out", at(other)))) << one << other;
            EXPECT_TRUE(is_refused(FileUse().writes("--a", at(one)).writes("--b", at(other))))
                << one << other;
        }
    // Also for a file that does not exist yet.
    const std::vector<std::string> of_new{"a/b/new", "a/b/../b/new", "short/new", "nowhere"};
    for (const std::string& one : of_new)
        for (const std::string& other : of_new)
            EXPECT_TRUE(is_refused(FileUse().writes("--a", at(one)).writes("--b", at(other))))
                << one << other;
    for (const std::string name : {"x/y/z", "x/../x/y/z"})
        EXPECT_TRUE(is_refused(FileUse().writes("--a", at("x/y/z")).writes("--b", at(name))));
}

TEST_F(FileUseTest, knows_a_relative_name) {
    const fs::path before = fs::current_path();
    fs::current_path(at("a"));
    EXPECT_TRUE(is_refused(FileUse().reads(fs::path("b/file")).writes("--out", at("hard"))));
    EXPECT_TRUE(is_refused(FileUse().writes("--a", "new").writes("--b", at("a/new"))));
    fs::current_path(before);
}

TEST_F(FileUseTest, lets_different_files_and_devices_pass) {
    EXPECT_TRUE(FileUse().reads(at("hard")).writes("--a", at("a/new")).writes("--b", at("new")).check());
    EXPECT_TRUE(FileUse().writes("--a", "/dev/null").writes("--b", "/dev/null").check());
    EXPECT_TRUE(FileUse().reads(at("hard")).writes("--a", at("loop")).check());
    EXPECT_TRUE(FileUse().reads(at("hard")).writes("--a", std::nullopt).check());
}

// Opens `path` for reading and writing during its lifetime.
class Open {
  public:
    explicit Open(const fs::path& path) : number_(open(path.c_str(), O_RDWR | O_CLOEXEC)) {
        EXPECT_GE(number_, 0);
    }
    Open(const Open&) = delete;
    Open& operator=(const Open&) = delete;
    ~Open() { close(number_); }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const char* folder : {"/dev/fd", "/proc/self/fd", "/proc/thread-self/fd"})
            all.push_back(std::string(folder) + "/" + std::to_string(number_));
        return all;
    }

  private:
    int number_;
};

TEST_F(FileUseTest, knows_a_file_by_its_descriptors) {
    const Open one(at("soft")), other(at("hard"));
    for (const std::string& name : one.names()) {
        EXPECT_TRUE(is_refused(FileUse().reads(at("hard")).writes("--out", name))) << name;
        EXPECT_TRUE(is_refused(FileUse().reads(fs::path(name)).writes("--out", at("hard")))) << name;
        EXPECT_TRUE(is_refused(FileUse().writes("--a", at("short/file")).writes("--b", name))) << name;
        EXPECT_TRUE(is_refused(FileUse().reads(fs::path(name)).writes_into("--frames", at("a/b"), {"f*"})))
            << name;
        for (const std::string& second : other.names())
            EXPECT_TRUE(is_refused(FileUse().writes("--a", name).writes("--b", second))) << name << second;
    }
}

TEST_F(FileUseTest, does_not_mix_outputs_in_a_pipe) {
    ASSERT_EQ(mkfifo(at("pipe").c_str(), 0600), 0);
    const Open pipe(at("pipe"));
    EXPECT_TRUE(FileUse().writes("--a", at("pipe")).check());
    EXPECT_TRUE(is_refused(FileUse().writes("--a", at("pipe")).writes("--b", at("pipe"))));
    for (const char* folder : {"/dev/fd", "/proc/self/fd"}) {
        const std::string name = std::string(folder) + pipe.names()[0].substr(7);
        EXPECT_TRUE(FileUse().writes("--a", name).check());
        EXPECT_TRUE(is_refused(FileUse().writes("--a", at("pipe")).writes("--b", name)));
    }
}

TEST_F(FileUseTest, lets_many_outputs_share_a_character_device) {
    const Open null("/dev/null");
    for (const std::string& name : null.names())
        EXPECT_TRUE(FileUse().writes("--a", name).writes("--b", name).writes("--c", "/dev/null").check())
            << name;
}

TEST_F(FileUseTest, knows_the_files_that_gdal_reads_beside_a_raster) {
    for (const char* name : {"hill.prj", "hill.PRJ", "hill.tif.aux.xml", "hill.tif.ovr"}) {
        write_bytes(at(name), "kept");
        EXPECT_TRUE(is_refused(FileUse().reads(at("hill.tif")).writes("--out", at(name)))) << name;
    }
    write_bytes(at("hill.json"), "of an earlier run");
    EXPECT_TRUE(FileUse().reads(at("hill.tif")).writes("--out", at("hill.json")).check());
}

TEST_F(FileUseTest, checks_folders_for_the_names_written_there) {
    const auto into = [&](const std::string& folder, std::vector<std::string> names) {
        return FileUse().reads(at("hard")).writes_into("--frames", at(folder), std::move(names));
    };
    EXPECT_TRUE(is_refused(into("a/b", {"f*e"})));
    EXPECT_TRUE(is_refused(into("short", {"x", "file"})));
    EXPECT_TRUE(is_refused(into("", {"so*"})));
    EXPECT_TRUE(into("a/b", {"fil", "ile"}).check());
    EXPECT_TRUE(into("a", {"*"}).check());
    EXPECT_TRUE(into("none", {"*"}).check());
    // Outputs that do not exist yet.
    EXPECT_TRUE(is_refused(into("none", {"*.png"}).writes("--out", at("none/a.png"))));
    EXPECT_TRUE(is_refused(into("none/", {"*.png"}).writes("--out", at("none/a.png"))));
    EXPECT_TRUE(is_refused(into("none", {"*.png"}).writes("--out", at("none"))));
    EXPECT_TRUE(into("none", {"*.png"}).writes("--out", at("none/a.csv")).check());
}

TEST_F(FileUseTest, requires_names) {
    EXPECT_TRUE(is_refused(FileUse().writes("--out", fs::path())));
    EXPECT_TRUE(is_refused(FileUse().writes_into("--frames", fs::path(), {"*"})));
}

}  // namespace
}  // namespace game::test
