// Resources that the machine or the caller may not provide: room for files, memory, a stack, descriptors.

#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "game/files/text_file.h"
#include "game/recording/recording_file.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/game/subcommands.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

// Expects status 3 and a message in the last line.
void expect_machine_fails(const Finished& finished, const std::string& told) {
    EXPECT_EQ(finished.status, 3) << finished.err;
    const auto end = finished.err.find_last_not_of('\n');
    const auto begin = finished.err.rfind('\n', end) + 1;
    const std::string last = finished.err.substr(begin);
    EXPECT_EQ(last.rfind("couloir: ", 0), 0u) << finished.err;
    EXPECT_NE(last.find(told), std::string::npos) << finished.err;
}

// Expects no empty, truncated or half-written files; a recording has whole lines.
void expect_whole_files_only(const fs::path& folder, const std::string& whole) {
    if (!fs::exists(folder)) return;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string bytes = read_bytes(entry.path());
        const bool is_recording = bytes.rfind("{\"format\":\"couloir\"", 0) == 0;
        if (is_recording) {
            EXPECT_EQ(bytes.back(), '\n') << entry.path();
            EXPECT_TRUE(read_recording(entry.path())) << entry.path();
        } else {
            EXPECT_EQ(entry.path().filename(), whole);
        }
    }
}

std::uintmax_t largest_in(const fs::path& path) {
    if (!fs::is_directory(path)) return fs::file_size(path);
    std::uintmax_t most = 0;
    for (const auto& entry : fs::directory_iterator(path)) most = std::max(most, entry.file_size());
    return most;
}

// A limit on file sizes stands for a full disk: the system refuses the same call.
TEST(FullDisk, is_told_by_every_writer_and_leaves_no_half_file) {
    const support::TemporaryFolder in, out;
    for (const Subcommand& each : writing_subcommands(in.path())) {
        if (each.only_refused) continue;
        auto options = each.outputs;
        options.insert(options.end(), each.folders.begin(), each.folders.end());
        for (const std::string& option : options) {
            const fs::path made = out.path() / "made";
            ASSERT_EQ(couloir(each.with({{option, made}}, in.path())).status, 0) << each.name << option;
            const auto size = largest_in(made);
            fs::remove_all(made);
            for (const std::uintmax_t limit : {std::uintmax_t{0}, size / 2, size * 7 / 8}) {
                SCOPED_TRACE(each.name + " " + option + " " + std::to_string(limit) + " of " +
                             std::to_string(size));
                const Finished full = couloir(each.with({{option, made}}, in.path()),
                                              {.out = "/dev/null", .limits = {{RLIMIT_FSIZE, limit}}});
                EXPECT_EQ(full.status, 3);
                if (fs::is_directory(made))
                    for (const auto& entry : fs::directory_iterator(made)) {
                        EXPECT_NE(entry.path().extension(), ".part");
                        EXPECT_GT(entry.file_size(), 0u);
                        EXPECT_LE(entry.file_size(), limit);
                    }
                else if (fs::exists(made))
                    expect_whole_files_only(out.path(), "");
                fs::remove_all(made);
                EXPECT_TRUE(fs::is_empty(out.path()));
            }
        }
    }
}

TEST(StandardOutput, that_cannot_be_written_is_the_machines_failure) {
    const support::TemporaryFolder in;
    std::vector<Arguments> calls{{"--help"}, {"--version"}, {"list"}, {"list", "--json"}, {"run", "--help"}};
    for (const Subcommand& each : writing_subcommands(in.path()))
        if (!each.only_refused) calls.push_back(each.with({}, in.path() / each.name));
    for (const Arguments& call : calls) {
        SCOPED_TRACE(call[0]);
        expect_machine_fails(couloir(call, {.out = "/dev/full"}), "standard output: cannot be written");
        expect_machine_fails(couloir(call, {.closed = {1}}), "standard output: cannot be written");
    }
}

TEST(StandardOutput, that_is_closed_lends_its_number_to_no_file) {
    const support::TemporaryFolder folder;
    const auto recording = folder.path() / "r.couloir", summary = folder.path() / "s.json";
    for (int closed = 1; closed < 8; ++closed) {
        std::vector<int> descriptors;
        for (int descriptor = 0; descriptor < 3; ++descriptor)
            if (closed & (1 << descriptor)) descriptors.push_back(descriptor);
        const Finished finished = couloir({"run", "landslide", "--grid", "16", "--seconds", "0.5", "--record",
                                           recording.string(), "--summary", summary.string()},
                                          {.closed = descriptors});
        EXPECT_EQ(finished.status, closed & 2 ? 3 : 0) << closed;
        const auto read = read_recording(recording);
        ASSERT_TRUE(read) << closed << ": " << read.error().sentence;
        EXPECT_TRUE(read->end && !read->warning) << closed;
        EXPECT_TRUE(Json::accept(read_bytes(summary))) << closed;
    }
}

// Never a signal, whatever is missing.
TEST(Memory, that_is_not_given_is_the_machines_failure) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer needs terabytes of addresses";
#endif
    const auto with = [](const Arguments& call, rlim_t megabytes) {
        return couloir(call, {.limits = {{RLIMIT_AS, megabytes << 20}}});
    };
    rlim_t least = 50;  // MB, enough to load the libraries
    while (with({"--version"}, least).status != 0) ASSERT_LT(least += 50, 4000u);
    const Arguments call{"run", "landslide", "--grid", "256", "--seconds", "0.1", "--threads", "8"};
    int failed = 0, done = 0;
    for (rlim_t megabytes = least; done < 2; megabytes += 25) {
        ASSERT_LT(megabytes, 8000u);
        const Finished finished = with(call, megabytes);
        EXPECT_TRUE(finished.status == 0 || finished.status == 3)
            << megabytes << ": " << finished.status << finished.err;
        ++(finished.status == 0 ? done : failed);
        if (finished.status == 3) {
            EXPECT_EQ(finished.err.rfind("couloir: ", 0), 0u) << finished.err;
        }
    }
    EXPECT_GT(failed, 0);
}

TEST(Stack, that_is_too_small_is_a_machine_failure) {
    for (const rlim_t kilobytes : {256u, 512u})
        expect_machine_fails(couloir({"list"}, {.limits = {{RLIMIT_STACK, kilobytes << 10}}}), "stack");
    EXPECT_EQ(couloir({"run", "landslide", "--seconds", "0.1", "--threads", "4"},
                      {.limits = {{RLIMIT_STACK, 1 << 20}}})
                  .status,
              0);
}

TEST(RecordingLock, keeps_others_from_a_recording_that_is_being_written) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "live.couloir";
    fs::create_symlink(path, folder.path() / "link");
    const auto once = [](const fs::path& to) {
        return Arguments{"run", "landslide", "--grid", "16", "--seconds", "0.2", "--record", to.string()};
    };
    const pid_t child =
        start_couloir({"run", "landslide", "--grid", "40", "--seconds", "36000", "--record", path.string()});
    std::error_code error;
    while (fs::file_size(path, error) < 20'000 || error)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    for (const fs::path& name : {path, folder.path() / "link"}) {
        expect_machine_fails(couloir(once(name)), name.string() + ": ");
        expect_machine_fails(couloir({"replay", "landslide", "--until", "1", "--summary", name.string()}),
                             name.string() + ": ");
    }
    EXPECT_EQ(couloir({"replay", path.string(), "--until", "6"}).status, 0);  // reading is always allowed
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    const auto read = read_recording(path);
    ASSERT_TRUE(read) << read.error().sentence;
    EXPECT_GT(read->last_tick(), 0);
    EXPECT_EQ(couloir(once(path)).status, 0);  // the lock ended with its process
}

TEST(RecordingLock, lets_one_of_several_that_begin_at_once) {
    const support::TemporaryFolder folder;
    for (int round = 0; round < 4; ++round) {
        const auto path = folder.path() / (std::to_string(round) + ".couloir");
        std::vector<pid_t> children;
        for (int i = 0; i < 4; ++i)
            children.push_back(start_couloir(
                {"run", "landslide", "--grid", "32", "--seconds", "10", "--record", path.string()}));
        int written = 0;
        for (const pid_t child : children) {
            int status = 0;
            waitpid(child, &status, 0);
            ASSERT_TRUE(WIFEXITED(status));
            EXPECT_TRUE(WEXITSTATUS(status) == 0 || WEXITSTATUS(status) == 3);
            written += WEXITSTATUS(status) == 0;
        }
        EXPECT_GE(written, 1);
        const auto read = read_recording(path);
        ASSERT_TRUE(read) << read.error().sentence;
        EXPECT_TRUE(read->end && !read->warning);
    }
}

TEST(Recorder, locks_within_one_process_too) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "a.couloir";
    {
        const auto first = record_into(path, small_scenario());
        ASSERT_TRUE(first);
        const std::string before = read_bytes(path);
        const auto second = record_into(path, small_scenario());
        ASSERT_FALSE(second);
        EXPECT_EQ(second.error().status, Failure::kMachine);
        EXPECT_FALSE(write_text(path, "text"));
        EXPECT_EQ(read_bytes(path), before);
    }
    EXPECT_TRUE(record_into(path, small_scenario()));
}

}  // namespace
}  // namespace game::test
