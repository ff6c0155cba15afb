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

#include "game/recording/recording_file.h"
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
    const Subcommand& named(const std::string& name) const {
        return *std::find_if(all_.begin(), all_.end(),
                             [&](const Subcommand& each) { return each.name == name; });
    }

    // Expects that the call is refused as a user error, and that no file is created or changed.
    void expect_refused(const std::vector<std::string>& arguments, const Surroundings& around = {}) {
        SCOPED_TRACE(line_of(arguments));
        const auto before = files_below(in()), beside = files_below(out());
        const Finished finished = couloir(arguments, around);
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

// An input with the name of an image, an export or a page. Refused before anything is drawn, so this needs no GL.
TEST_F(Outputs, that_are_drawn_never_replace_an_input) {
    const std::map<std::string, fs::path> names{
        {"--frames", "tick_000000.png"}, {"--export", "summary.json"}, {"--out", "index.html"}};
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

TEST_F(Outputs, never_replace_another_output) {
    const fs::path there = out() / "there";
    write_bytes(there, "kept");
    for (const Subcommand& each : all())
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

// The file names that a subcommand writes into a folder, found by running it: none may lead to an input. Each name and each
// input at least once, because neither depends on the other.
TEST_F(Outputs, in_a_folder_never_replace_an_input) {
    for (const Subcommand& each : all())
        for (const std::string& option : each.folders) {
            const fs::path made = out() / "made", again = out() / "again";
            const Finished finished = couloir(each.with({{option, made}}, in()));
            ASSERT_EQ(finished.status, 0) << each.name << ": " << finished.err;
            std::vector<std::string> names;
            for (const auto& [name, bytes] : files_below(made)) names.push_back(name);
            fs::remove_all(made);
            ASSERT_FALSE(names.empty()) << each.name;
            const std::size_t inputs = each.inputs.size();
            for (std::size_t i = 0; inputs > 0 && i < std::max(names.size(), inputs); ++i) {
                fs::create_directories(again);
                fs::create_hard_link(each.inputs[i % inputs], again / names[i % names.size()]);
                expect_refused(each.with({{option, again}}, in()));
                fs::remove_all(again);
            }
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
                text_.append(bytes.data(), static_cast<std::size_t>(n));
                if (text_.back() != '\4') continue;
                text_.pop_back();  // the end may come together with what is before it
                return;
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

// Each kind of output, to each kind of input, through a descriptor.
TEST_F(Outputs, never_replace_an_input_through_a_descriptor) {
    for (const Subcommand& each : all())
        for (const std::string& option : each.outputs)
            for (const fs::path& input : each.inputs)
                expect_refused(each.with({{option, "/dev/fd/9"}}, out()), {.opened = {{9, input}}});
}

TEST_F(Outputs, never_share_a_descriptor) {
    const fs::path there = out() / "there";
    write_bytes(there, "kept");
    const std::vector<std::pair<const char*, fs::path>> pairs{
        {"/dev/fd/9", "/dev/fd/9"}, {"/dev/fd/9", "/proc/self/fd/8"}, {"/dev/fd/9", there}};
    for (const Subcommand& each : all())
        for (std::size_t b = 1; b < each.outputs.size(); ++b)
            for (const auto& [one, other] : pairs)
                expect_refused(each.with({{each.outputs[0], one}, {each.outputs[b], other}}, out()),
                               {.opened = {{9, there}, {8, there}}});
}

// What a subcommand prints goes to standard output, so that nothing else may.
TEST_F(Outputs, never_share_standard_output) {
    const fs::path printed = out() / "printed";
    write_bytes(printed, "");
    for (const Subcommand& each : all())
        for (const std::string& option : each.outputs) {
            if (each.name == "track") continue;
            for (const fs::path& name : {fs::path("/dev/stdout"), fs::path("/dev/fd/1"), printed})
                expect_refused(each.with({{option, name}}, out()), {.out = printed});
            // A pipe that nobody reads: it is refused before a byte is written.
            const fs::path pipe = out() / "pipe";
            ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
            const int both_ends = open(pipe.c_str(), O_RDWR | O_CLOEXEC);
            expect_refused(each.with({{option, "/dev/stdout"}}, out()), {.out = pipe});
            expect_refused(each.with({{option, "/dev/fd/9"}}, out()), {.out = pipe, .opened = {{9, pipe}}});
            close(both_ends);
            fs::remove(pipe);
            if (each.only_refused) continue;
            const Finished null = couloir(each.with({{option, "/dev/stdout"}}, out()), {.out = "/dev/null"});
            EXPECT_EQ(null.status, 0) << each.name << " " << option << null.err;
        }
}

TEST_F(Outputs, that_are_alone_on_standard_output_may_go_there) {
    const Subcommand& track = named("track");
    const Finished alone = couloir(track.with({}, out()));
    const Finished through = couloir(track.with({{"--out", "/dev/stdout"}}, out()));
    EXPECT_EQ(through.status, 0) << through.err;
    EXPECT_EQ(through.out, alone.out);
}

TEST_F(Outputs, in_a_folder_never_replace_standard_output) {
    const Subcommand& track = named("track");
    const fs::path folder = out() / "images", file = folder / "front_000000.png";
    fs::create_directories(folder);
    EXPECT_EQ(couloir(track.with({{"--frames", folder}}, out()), {.out = file}).status, 2);
}

// The names of a folder's files that a subcommand may write.
constexpr std::array kNamesInFolders{"index.html",      "figure-06.png",      "numbers.csv",
                                     "tick_000000.png", "map_peak_depth.png", "front_000000.png"};

TEST_F(Outputs, keep_what_they_held_if_the_call_is_refused) {
    const fs::path there = out() / "there", folder = out() / "folder";
    write_bytes(there, "kept");
    fs::create_directories(folder);
    for (const char* name : kNamesInFolders) write_bytes(folder / name, "kept");
    for (const Subcommand& each : all())
        for (const std::vector<std::string>& refusal : refusals_of(each)) {
            const auto expect_kept = [&](const std::string& option, const fs::path& path) {
                auto arguments = each.with({{option, path}}, out());
                arguments.insert(arguments.end(), refusal.begin(), refusal.end());
                expect_refused(arguments);
            };
            for (const std::string& option : each.outputs) expect_kept(option, there);
            for (const auto* options : {&each.folders, &each.drawn})
                for (const std::string& option : *options) expect_kept(option, folder);
        }
}

TEST_F(Outputs, keep_what_they_held_if_an_input_is_refused) {
    const fs::path there = out() / "there";
    write_bytes(there, "kept");
    for (const Subcommand& each : subcommands_refused_by_content(in()))
        for (const std::string& option : each.outputs) {
            SCOPED_TRACE(each.name);
            expect_refused(each.with({{option, there}}, out()));
        }
}

// Two houses at one place: the second is refused at tick 12, when the recording has begun.
TEST_F(Outputs, of_a_run_that_fails_later_keep_what_they_replaced_beside_them) {
    const fs::path scene = in() / "clash.toml", recording = out() / "mine.couloir";
    const std::string house =
        "house = { x = 20, y = 20, turn = 0, length = 5, width = 5, height = 5, "
        "strength = 5 }\n";
    write_bytes(scene,
                "[terrain]\ngenerator = \"slope-of-soil\"\ngrid = 16\nlength = 64\nbreak_at = 32\n"
                "[cover]\nmaterial = \"soil\"\n[physics]\n[[command]]\nat = 0.1\n" +
                    house + "[[command]]\nat = 0.2\n" + house);
    write_bytes(recording, "kept");
    const Finished failed = couloir({"run", scene, "--seconds", "1", "--record", recording});
    EXPECT_EQ(failed.status, 2) << failed.err;
    const fs::path beside = out() / "mine.before.couloir";
    EXPECT_EQ(read_bytes(beside), "kept");
    EXPECT_NE(failed.err.find(beside.string()), std::string::npos) << failed.err;
    const auto read = read_recording(recording);
    ASSERT_TRUE(read) << read.error().sentence;
    EXPECT_EQ(read->states.back().tick, 12);

    // A second one takes another name, and one that succeeds leaves nothing beside its own.
    EXPECT_EQ(couloir({"run", scene, "--seconds", "1", "--record", recording}).status, 2);
    EXPECT_EQ(read_bytes(beside), "kept");
    EXPECT_TRUE(fs::remove(out() / "mine.before2.couloir"));
    EXPECT_EQ(couloir({"run", scene, "--seconds", "0.1", "--record", recording}).status, 0);
    EXPECT_EQ(files_below(out()).size(), 2u);
}

}  // namespace
}  // namespace game::test
