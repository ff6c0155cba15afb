// Every subcommand, with every output option and every input file.

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "tests/game/program.h"
#include "tests/game/subcommands.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

// All regular files below a folder.
std::map<std::string, std::string> files_below(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && !entry.is_symlink())
            files[entry.path().lexically_relative(folder).string()] = read_bytes(entry.path());
    return files;
}

std::string line_of(const std::vector<std::string>& arguments) {
    std::string line = "couloir";
    for (const std::string& argument : arguments) line += " " + argument;
    return line;
}

class Outputs : public testing::Test {
  protected:
    fs::path in() const { return in_.path(); }
    fs::path out() const { return out_.path(); }
    const std::vector<Subcommand>& all() const { return all_; }

    // Expects that the call is refused as a user error, and that no file is created or changed.
    void expect_refused(const std::vector<std::string>& arguments) {
        SCOPED_TRACE(line_of(arguments));
        const auto before = files_below(in()), beside = files_below(out());
        const Finished finished = couloir(arguments);
        EXPECT_EQ(finished.status, 2) << finished.err;
        EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
        EXPECT_EQ(files_below(in()), before);
        EXPECT_EQ(files_below(out()), beside);
    }

    // Another name of a file; successive calls use different kinds.
    fs::path another_name(const fs::path& file) {
        const fs::path name = out() / ("name" + std::to_string(names_++));
        switch (names_ % 4) {
            case 0:
                return file;
            case 1:
                fs::create_hard_link(file, name);
                return name;
            case 2:
                fs::create_symlink(file, name);
                return name;
            default:
                return file.parent_path() / "." / ".." / file.parent_path().filename() / file.filename();
        }
    }

  private:
    support::TemporaryFolder in_, out_;
    std::vector<Subcommand> all_ = writing_subcommands(in_.path());
    int names_ = 0;
};

TEST_F(Outputs, never_replace_an_input) {
    for (const Subcommand& each : all())
        for (const std::string& option : each.outputs)
            for (const fs::path& input : each.inputs)
                expect_refused(each.with({{option, another_name(input)}}, out()));
}

TEST_F(Outputs, never_replace_another_output) {
    const fs::path there = out() / "there";
    write_bytes(there, "kept");
    for (const Subcommand& each : all())
// An input with the name of an image or an export. Refused before anything is drawn, so this needs no GL.
TEST_F(Outputs, that_are_drawn_never_replace_an_input) {
    const std::map<std::string, fs::path> names{{"--frames", "tick_000000.png"},
                                                {"--export", "frames/tick_000000.png"}};
    for (const Subcommand& each : all())
        for (const std::string& option : each.drawn)
            for (const fs::path& input : each.inputs) {
                const fs::path folder = out() / "drawn", name = folder / names.at(option);
                fs::create_directories(name.parent_path());
                fs::create_hard_link(input, name);
                expect_refused(each.with({{option, folder}}, out()));
                fs::remove_all(folder);
            }
}

// The inputs of `only_refused` are refused because they are inputs: to another name, reading succeeds.
TEST_F(Outputs, are_refused_only_because_they_are_inputs) {
    for (const Subcommand& each : all()) {
        if (each.arguments[0] != "run") continue;
        const Finished finished = couloir(each.with({{"--summary", out() / "new"}}, out()));
        EXPECT_EQ(finished.status, 0) << each.name << finished.err;
    }
}

        for (std::size_t a = 0; a < each.outputs.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) {
                const fs::path name = (a + b) % 2 == 0 ? there : out() / "new" / "name";
                expect_refused(each.with(
                    {{each.outputs[a], name}, {each.outputs[b], name.parent_path() / "." / name.filename()}},
                    out()));
            }
}

TEST_F(Outputs, have_a_name) {
    for (const Subcommand& each : all())
        for (const auto* options : {&each.outputs, &each.folders, &each.drawn})
            for (const std::string& option : *options) expect_refused(each.with({{option, ""}}, out()));
}

// The file names that a subcommand writes into a folder, found by running it: none may lead to an input.
TEST_F(Outputs, in_a_folder_never_replace_an_input) {
    for (const Subcommand& each : all())
        for (const std::string& option : each.folders) {
            const fs::path made = out() / "made", again = out() / "again";
            const Finished finished = couloir(each.with({{option, made}}, in()));
            ASSERT_EQ(finished.status, 0) << each.name << ": " << finished.err;
            const auto names = files_below(made);
            EXPECT_FALSE(names.empty()) << each.name;
            for (const auto& [name, bytes] : names)
                for (const fs::path& input : each.inputs) {
                    fs::create_directories(again);
                    fs::create_hard_link(input, again / name);
                    expect_refused(each.with({{option, again}}, in()));
                    fs::remove_all(again);
                }
            fs::remove_all(made);
        }
}

// A pipe that a thread reads to its end.
class Pipe {
  public:
    explicit Pipe(const fs::path& path) : path_(path) {
        EXPECT_EQ(mkfifo(path.c_str(), 0600), 0);
        keep_ = open(path.c_str(), O_RDWR | O_CLOEXEC);  // so that opening the other end does not block
        reader_ = std::thread([this] {
            std::array<char, 4096> bytes{};
            for (ssize_t n; (n = read(keep_, bytes.data(), bytes.size())) > 0;) {
                if (bytes[static_cast<std::size_t>(n) - 1] == '\4') return;
                text_.append(bytes.data(), static_cast<std::size_t>(n));
            }
        });
    }
    std::string finish() {
        EXPECT_EQ(::write(keep_, "\4", 1), 1);
        reader_.join();
        close(keep_);
        return text_;
    }

  private:
    fs::path path_;
    int keep_ = -1;
    std::thread reader_;
    std::string text_;
};

TEST_F(Outputs, go_through_pipes_and_links) {
    int n = 0;
    for (const Subcommand& each : all())
        for (const std::string& option : each.outputs) {
            if (each.only_refused) continue;
            SCOPED_TRACE(each.name + " " + option);
            const fs::path folder = out() / std::to_string(n++);
            fs::create_directories(folder / "far");
            const fs::path pipe = folder / "far" / "pipe", file = folder / "far" / "file";
            fs::create_symlink("far/pipe", folder / "to_pipe");
            fs::create_symlink("far/file", folder / "to_file");
            Pipe reader(pipe);
            const Finished through = couloir(each.with({{option, folder / "to_pipe"}}, folder));
            const std::string text = reader.finish();
            EXPECT_EQ(through.status, 0) << through.err;
            EXPECT_TRUE(fs::is_fifo(pipe));
            // Once to a new file, once to an existing one.
            for (int time = 0; time < 2; ++time) {
                const Finished replaced = couloir(each.with({{option, folder / "to_file"}}, folder));
                EXPECT_EQ(replaced.status, 0) << replaced.err;
                EXPECT_EQ(text.substr(0, 10), read_bytes(file).substr(0, 10));
            }
            EXPECT_TRUE(fs::is_symlink(folder / "to_pipe") && fs::is_symlink(folder / "to_file"));
            EXPECT_EQ(std::distance(fs::directory_iterator(folder / "far"), {}), 2);
        }
}

TEST_F(Outputs, to_a_full_device_are_the_machines_failure) {
    for (const Subcommand& each : all())
        for (const std::string& option : each.outputs) {
            if (each.only_refused) continue;
            const fs::path link = out() / "full";
            fs::create_symlink("/dev/full", link);
            const Finished finished = couloir(each.with({{option, link}}, out()));
            EXPECT_EQ(finished.status, 3) << each.name << " " << option;
            EXPECT_NE(finished.err.find(link.string() + ": cannot be written: "), std::string::npos)
                << finished.err;
            EXPECT_TRUE(fs::is_symlink(link));
            fs::remove(link);
        }
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(Outputs, to_standard_output_come_before_what_is_printed) {
    for (const Subcommand& each : all())
        for (const std::string& option : each.outputs) {
            if (each.only_refused) continue;
            SCOPED_TRACE(each.name + " " + option);
            const fs::path file = out() / "file";
            const Finished alone = couloir(each.with({{option, file}}, out()));
            const Finished both = couloir(each.with({{option, "/dev/stdout"}}, out()));
            EXPECT_EQ(both.status, 0) << both.err;
            EXPECT_EQ(both.out.substr(0, 10), read_bytes(file).substr(0, 10));
            EXPECT_GE(both.out.size() + 1000, read_bytes(file).size() + alone.out.size());
        }
    const Subcommand& replay = all()[2];
    const fs::path file = out() / "both";
    const Finished clash = couloir(replay.with({{"--summary", file}}, out()), {.out = file});
    EXPECT_EQ(clash.status, 2);
}

}  // namespace
}  // namespace game::test
